#include "run/recorder.hpp"

#include <gtest/gtest.h>

#include "case/case_file.hpp"
#include "run/setup.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {
namespace {

TEST(Recorder, RefusesAnArchiveThatLacksSnapshots) {
  const Case values = parse_case(
      "[system]\ndimension = 1\nspheres = 2\nrestitution = 0.9\nsides = [10]\n"
      "[start]\narrangement = \"given\"\npositions = [[1], [5]]\nvelocities = [[1], [1]]\n"
      "[drive]\nkind = \"none\"\n[run]\ntime = 100\n[output]\nsnapshot_interval = 0.5\n",
      "test.toml", {});
  const TemporaryFolder folder;
  OutputFile file(folder.path / "out.h5", output_header(values), Existing::replace);
  auto simulation = new_simulation<1, double>(values);
  simulation.wait_until(10);
  const auto read = [&](std::int64_t snapshots) {
    ArchiveWriter writer;
    writer(std::optional<CollisionRow>(), snapshots, 9.5, std::int64_t{0});
    ArchiveReader reader(writer.bytes());
    Recorder<1, double>(values, simulation, file, reader);
  };
  EXPECT_NO_THROW(read(21));
  EXPECT_NO_THROW(read(20));  // due at this moment
  EXPECT_THROW(read(19), ArchiveError);
  EXPECT_THROW(read(0), ArchiveError);  // would count up to now, however late that is
  EXPECT_THROW(read(-1), ArchiveError);
}

}  // namespace
}  // namespace zenosphere
