#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <vector>

#include "case/case_file.hpp"
#include "fuzz/memory_file.hpp"
#include "fuzz/readers.hpp"
#include "model/errors.hpp"
#include "result/summary.hpp"
#include "run/observers.hpp"
#include "run/random_driving.hpp"
#include "run/setup.hpp"
#include "storage/checksum.hpp"
#include "storage/durable.hpp"
#include "storage/journal.hpp"

/// Readers of what a run keeps for itself: its journal and the state in its checkpoints.
namespace zenosphere::fuzz {
namespace {

using Owned = std::vector<std::uint8_t>;

constexpr std::uint64_t journal_magic = 0x4c4e524a4f4e455a;
constexpr std::size_t journal_header_size = 8 + 4 + (4 * 8 + 4) + 4;

/// A journal of the records that `bytes` describe, with checksums that are right.
Owned whole_journal(Bytes bytes) {
  ArchiveWriter head;
  head(journal_magic, std::uint32_t{1}, Basis{});
  head(checksum(head.bytes()));
  Owned made = head.bytes();
  std::uint32_t seed = 0;
  std::memcpy(&seed, made.data() + journal_header_size - sizeof seed, sizeof seed);
  while (bytes.size() >= 3) {
    const std::uint32_t kind = bytes[0];
    const std::size_t claimed = bytes[1] + std::size_t{256} * bytes[2];
    const Bytes payload = bytes.subspan(3, std::min(claimed, bytes.size() - 3));
    bytes = bytes.subspan(3 + payload.size());
    ArchiveWriter around, record;
    around(kind, std::uint64_t{payload.size()});
    record(kind, checksum(payload, checksum(around.bytes(), seed)), std::uint64_t{payload.size()});
    made.insert(made.end(), record.bytes().begin(), record.bytes().end());
    made.insert(made.end(), payload.begin(), payload.end());
  }
  return made;
}

/// Reads a journal in full, as folding it into the output file does.
void read_all(const FileDescriptor& file) {
  contents_of(file, Thoroughness::checkpoints);
  contents_of(file, Thoroughness::every_byte);
  JournalReader reader(file);
  while (const auto record = reader.next()) {
    const zenosphere::Bytes payload = reader.payload(*record);
    ArchiveReader archive(payload);
    if (record->kind == RecordKind::rows) archive.next<CollisionRows>();
    if (record->kind == RecordKind::snapshot) archive.next<Snapshot>();
  }
}

/// The runs whose states are read: a gas that cools, a sheared one, a column on the ground with a
/// contact model, rods that have collapsed, and disks that are kicked and whose collisions rotate.
const Case& small_case(std::uint8_t choice) {
  const std::filesystem::path folder = ZENOSPHERE_SOURCE_DIR "/fuzz/states";
  static const std::array cases{
      read_case(folder / "cooling.toml", {}), read_case(folder / "shear.toml", {}),
      read_case(folder / "column.toml", {}), read_case(folder / "collapse.toml", {}),
      read_case(folder / "kicked.toml", {})};
  return cases[choice % cases.size()];
}

template <int Dim>
void go_on(const Case& values, Bytes bytes) {
  ArchiveReader state(bytes);
  state.next<std::uint32_t>();  // version, dimension and digits: run/state_head.hpp
  state.next<std::int32_t>();
  state.next<std::int32_t>();
  require_archived(state.left() / 32 >= static_cast<std::size_t>(values.system.spheres), "short");
  auto simulation = archived_simulation<Dim, double>(values, state);
  require_archived(simulation.spheres() == values.system.spheres, "other spheres");
  RandomDriving<Dim, double> driving(values);
  Observers<Dim, double> observers(values, simulation);
  state(driving, observers);
  if (driving.is_on()) driving.kick(simulation, observers.measurements());
  constexpr int collisions = 100;
  for (int k = 0; k < collisions && !observers.has_violation(); ++k) {
    if (simulation.is_at_rest()) break;
    const auto collision = simulation.collision_until(simulation.time() + 10);
    if (!collision) break;
    observers.observe(*collision, simulation);
  }
  observers.look(simulation);
  Summary summary;
  observers.add_to(summary, simulation);
  to_json(summary, Dim);
}

}  // namespace

void journal(Bytes bytes) {
  if (bytes.empty()) return;
  const bool is_made_whole = bytes[0] % 2 == 1;
  const Owned made = is_made_whole ? whole_journal(bytes.subspan(1)) : Owned();
  const MemoryFile file(is_made_whole ? Bytes(made) : bytes.subspan(1));
  try {
    read_all(FileDescriptor(file.path(), O_RDONLY));
  } catch (const ArchiveError&) {  // refused
  }
}

void checkpoint(Bytes bytes) {
  if (bytes.empty()) return;
  const Case& values = small_case(bytes[0]);
  const Bytes state = bytes.subspan(1);
  try {
    if (values.system.dimension == 1) go_on<1>(values, state);
    if (values.system.dimension == 2) go_on<2>(values, state);
    if (values.system.dimension == 3) go_on<3>(values, state);
  } catch (const ArchiveError&) {  // refused
  }
}

}  // namespace zenosphere::fuzz
