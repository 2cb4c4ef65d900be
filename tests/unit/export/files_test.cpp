#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "export/base64.hpp"
#include "export/export_run.hpp"
#include "export/vtk_frame.hpp"
#include "model/errors.hpp"
#include "storage/atomic_file.hpp"
#include "unit/storage/output_fixture.hpp"

namespace zenosphere {
namespace {

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ExportFiles : public OutputFileTest {
 protected:
  /// The same bytes, in pieces of one size.
  std::string in_base64(const std::string& text, std::size_t piece) {
    const fs::path target = folder.path / "text";
    fs::remove(target);
    NewFile file(target, target);
    Base64 base64(file);
    for (std::size_t first = 0; first < text.size(); first += piece) {
      const std::string part = text.substr(first, piece);
      base64.write({reinterpret_cast<const std::uint8_t*>(part.data()), part.size()});
    }
    base64.close();
    file.close();
    return content_of(target);
  }
};

TEST_F(ExportFiles, Base64GivesTheTextsOfItsStandard) {  // RFC 4648, section 10
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"},
                                                                 {"\xfb\xff\xfe", "+//+"}};
  for (const auto& [text, expected] : vectors) {
    EXPECT_EQ(in_base64(text, 1), expected);
    EXPECT_EQ(in_base64(text, 4), expected);
  }
}

TEST_F(ExportFiles, NewFileHoldsWhatWasWrittenInAnyPieces) {
  const fs::path target = folder.path / "text";
  NewFile file(target, target);
  std::string expected;
  for (std::size_t size : {1U, 1000000U, 3000000U, 2U, 1048576U, 1048577U}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    file.write(piece);
    expected += piece;
  }
  file.close();
  EXPECT_EQ(content_of(target), expected);
}

TEST_F(ExportFiles, AtomicFileThatIsNotPutInPlaceLeavesNothing) {
  { const AtomicFile frames(folder.path / "frames", Existing::refuse, folder_of_vtk_frames()); }
  {
    const AtomicFile text(folder.path / "text", Existing::refuse);
    std::ofstream(text.path()) << "half";
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(ExportFiles, AtomicFileDoesNotReplaceWhatAnotherProcessMadeMeanwhile) {
  AtomicFile text(folder.path / "text", Existing::refuse);
  std::ofstream(text.path()) << "new";
  std::ofstream(folder.path / "text") << "theirs";
  EXPECT_THROW(text.put_in_place(), OutputError);
  EXPECT_EQ(content_of(folder.path / "text"), "theirs");
}

TEST_F(ExportFiles, CollectionEscapesItsPaths) {
  const std::string text = vtk_collection({{.time = 0.25, .path = "a&b<\"c\"/frame-000001.vtp"}});
  EXPECT_NE(text.find("timestep=\"0.25\""), std::string::npos);
  EXPECT_NE(text.find("file=\"a&amp;b&lt;&quot;c&quot;/frame-000001.vtp\""), std::string::npos);
}

TEST_F(ExportFiles, FrameNamesSortAsTheirNumbers) {
  EXPECT_EQ(vtk_frame_name(12), "frame-000012.vtp");
  EXPECT_EQ(vtk_frame_name(1234567), "frame-1234567.vtp");
}

const std::string plane_case =
    "[system]\ndimension = 2\nspheres = 2\nrestitution = 1\nsides = [8, 8]\n"
    "[start]\narrangement = \"random\"\ngranular_temperature = 1\n"
    "[drive]\nkind = \"none\"\n[run]\ncollisions = 3\n";

TEST_F(ExportFiles, InterruptedExportWritesNothing) {
  {
    OutputFile output(path, {plane_case, plane_case, 2, 2}, Existing::refuse);
    write_run(output, 0);
    finish(output, 0);
  }
  std::atomic<bool> interrupt = true;
  Export request{.run = path, .target = folder.path / "text", .interrupt = &interrupt};
  for (const char* format : {"extxyz", "csv-observables"}) {
    request.format = export_format(format);
    EXPECT_TRUE(export_run(request).interrupted);
    EXPECT_EQ(files(), 1);
  }
  request.format = export_format("vtp");
  request.target = folder.path / "a.pvd";
  EXPECT_TRUE(export_run(request).interrupted);
  EXPECT_EQ(files(), 1);
  interrupt = false;
  EXPECT_EQ(export_run(request).written, 1);
  EXPECT_EQ(files(), 3);
}

}  // namespace
}  // namespace zenosphere
