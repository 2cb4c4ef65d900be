#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/readers.hpp"

namespace zenosphere::fuzz {
namespace {

/// Feeds every file of a corpus to its reader, which ends the process where it does what it must
/// not; what the fuzzers found once is among them.
void replay(const std::string& target, void (*reader)(Bytes)) {
  const std::filesystem::path folder = ZENOSPHERE_SOURCE_DIR "/fuzz/corpus/" + target;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    std::ifstream stream(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    reader({reinterpret_cast<const std::uint8_t*>(content.data()), content.size()});
  }
}

TEST(Corpus, OfCaseFilesIsReadOrRefused) { replay("case_file", case_file); }
TEST(Corpus, OfSweepFilesIsReadOrRefused) { replay("sweep_file", sweep_file); }
TEST(Corpus, OfSummariesIsReadOrRefused) { replay("summary", summary); }
TEST(Corpus, OfStartsInTextIsReadOrRefused) { replay("start_text", start_text); }
TEST(Corpus, OfStartsInHdf5IsReadOrRefused) { replay("start_output", start_output); }
TEST(Corpus, OfOutputFilesIsReadOrRefused) { replay("output_file", output_file); }
TEST(Corpus, OfVerifiedFilesIsReadOrRefused) { replay("verified_file", verified_file); }
TEST(Corpus, OfJournalsIsReadOrRefused) { replay("journal", journal); }
TEST(Corpus, OfCheckpointsIsReadOrRefused) { replay("checkpoint", checkpoint); }

}  // namespace
}  // namespace zenosphere::fuzz
