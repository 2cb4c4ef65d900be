#include "storage/integrity.hpp"

#include <fstream>
#include <iterator>

#include "storage/hdf5_series.hpp"
#include "storage/keep_adjudication.hpp"
#include "storage/recovery.hpp"
#include "unit/storage/output_fixture.hpp"

namespace zenosphere {
namespace {

class IntegrityTest : public OutputFileTest {
 protected:
  void write_finished() const {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 3);
    finish(output, 3);
  }

  /// What is wrong with the file, behind its name.
  std::string problem() const {
    try {
      checked_integrity(path);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path.string().size() + 2);
    }
    return "";
  }

  std::string content() const {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  void replace_content(const std::string& bytes) const {
    std::ofstream(path, std::ios::binary) << bytes;
  }
};

constexpr const char* advice = "; take another copy of it, or run its case again";

TEST_F(IntegrityTest, FinishedFileMatchesByteForByte) {
  write_finished();
  EXPECT_EQ(checked_integrity(path), Integrity::bytes_unchanged);
}

TEST_F(IntegrityTest, UnfinishedFileHasNoChecksums) {
  {
    OutputFile output(path, planar_pair, Existing::refuse);
    write_run(output, 3);
    output.checkpoint(checkpoint(3));
  }
  EXPECT_EQ(checked_integrity(path), Integrity::unknown);
}

TEST_F(IntegrityTest, FileOfAnotherKindHasNoChecksums) {
  replace_content("not HDF5");
  EXPECT_EQ(checked_integrity(path), Integrity::unknown);
  EXPECT_EQ(checked_integrity(folder.path / "nowhere.h5"), Integrity::unknown);
}

TEST_F(IntegrityTest, EveryFlippedBitIsFound) {
  write_finished();
  const std::string whole = content();
  constexpr std::size_t step = 40009;  // a prime, so that all places of a byte are met
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += step) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    replace_content(damaged);
    // What HDF5 no longer knows as its own is refused by who reads it.
    const auto look = [&] {
      checked_integrity(path);
      read_output_info(path);
    };
    EXPECT_THROW(look(), InputError) << "bit " << bit;
  }
}

TEST_F(IntegrityTest, FileThatAnotherProgramOpenedForWritingMatchesValueForValue) {
  write_finished();
  hdf5::write_attribute(hdf5::reopened_file(path), "note", "of its reader");
  EXPECT_EQ(checked_integrity(path), Integrity::values_unchanged);
}

TEST_F(IntegrityTest, ChangedDatasetIsNamed) {
  write_finished();
  {
    const hdf5::Handle file = hdf5::reopened_file(path);
    hdf5::Series(file, "collisions/gap", hdf5::Type::float64).replace(std::vector{0.0, 1.0, 2.0});
  }
  EXPECT_EQ(problem(),
            std::string("is damaged (/collisions/gap is not what was written)") + advice);
}

TEST_F(IntegrityTest, ChangedAttributeIsNamed) {
  write_finished();
  hdf5::write_attribute(hdf5::opened(hdf5::reopened_file(path), "collisions"), "complete",
                        std::uint8_t{0});
  EXPECT_EQ(problem(),
            std::string("is damaged (the attribute complete of /collisions is not what was "
                        "written)") +
                advice);
}

TEST_F(IntegrityTest, LostAndShortenedDatasetsAreCounted) {
  write_finished();
  {
    const hdf5::Handle file = hdf5::reopened_file(path);
    hdf5::remove(hdf5::opened(file, "collisions"), "gap");
    hdf5::Series(file, "collisions/time", hdf5::Type::float64).truncate(2);
  }
  EXPECT_EQ(
      problem(),
      std::string("is damaged (/collisions/gap and 1 more are not what was written)") + advice);
}

TEST_F(IntegrityTest, ChangedListIsNamed) {
  write_finished();
  {
    const hdf5::Handle own = hdf5::opened(hdf5::reopened_file(path), "zenosphere");
    std::string list = hdf5::text(own, "checksums");
    list.front() ^= 1;
    hdf5::write_text(own, "checksums", list);
  }
  EXPECT_EQ(problem(),
            std::string("is damaged (/zenosphere/checksums is not what was written)") + advice);
}

TEST_F(IntegrityTest, ByteOutsideOfAllValuesIsFound) {
  write_finished();
  std::string bytes = content();
  bytes[bytes.size() / 2] ^= 1;  // room for rows of the log that never came
  replace_content(bytes);
  EXPECT_EQ(problem(),
            std::string("is damaged (outside of its datasets and attributes, which are what was "
                        "written)") +
                advice);
}

TEST_F(IntegrityTest, DamagedRunIsNotMadeLonger) {
  write_finished();
  {
    const hdf5::Handle file = hdf5::reopened_file(path);
    hdf5::Series(file, "collisions/gap", hdf5::Type::float64).replace(std::vector{0.0, 1.0, 2.0});
  }
  EXPECT_THROW(recover(path), InputError);
  EXPECT_EQ(files(), 1);
}

TEST_F(IntegrityTest, AdjudicationGetsChecksumsToo) {
  write_finished();
  keep_adjudication(path, "{}");
  EXPECT_EQ(checked_integrity(path), Integrity::bytes_unchanged);
  hdf5::write_text(hdf5::opened(hdf5::reopened_file(path), "zenosphere"), "adjudication", "[]");
  EXPECT_NE(problem().find("/zenosphere/adjudication"), std::string::npos);
}

}  // namespace
}  // namespace zenosphere
