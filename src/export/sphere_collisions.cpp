#include "export/sphere_collisions.hpp"

#include <fmt/format.h>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

/// How many collisions from the first one on a log holds, if it lacks none between its ends.
std::int64_t reach_of(const RunReader& run) {
  const std::int64_t pieces = run.log_pieces();
  if (pieces == 0) return 0;
  const auto first = run.log_piece(0);
  const auto last = run.log_piece(pieces - 1);
  return !first.empty() && first.front().k == 1 && !last.empty() ? last.back().k : 0;
}

}  // namespace

SphereCollisions::SphereCollisions(const RunReader& run, const std::filesystem::path& path)
    : run_(run),
      path_(path),
      reach_(reach_of(run)),
      counts_(static_cast<std::size_t>(run.info().spheres)) {}

std::span<const std::int64_t> SphereCollisions::up_to(std::int64_t step) {
  while (done_ < step) {
    if (next_ == piece_.size()) {
      read_piece();
    } else {
      count(piece_[next_++]);
    }
  }
  if (done_ == step) return counts_;
  throw InputError(
      fmt::format("{}: a snapshot at collision {} comes after one at {}; it is damaged",
                  path_.string(), step, done_));
}

void SphereCollisions::read_piece() {
  if (pieces_ == run_.log_pieces()) {
    throw InputError(
        fmt::format("{}: the log ends at collision {} (its last row is {}); it is "
                    "damaged",
                    path_.string(), done_, reach_));
  }
  piece_ = run_.log_piece(pieces_++);
  next_ = 0;
}

void SphereCollisions::count(const CollisionRow& row) {
  const auto spheres = static_cast<std::int64_t>(counts_.size());
  const bool is_right =
      row.k == done_ + 1 && row.i >= 0 && row.i < spheres && row.j > row.i && row.j <= spheres + 1;
  if (!is_right) {
    throw InputError(
        fmt::format("{}: collision {} of spheres {} and {} follows collision {} of "
                    "{} spheres; it is damaged",
                    path_.string(), row.k, row.i, row.j, done_, spheres));
  }
  ++counts_[static_cast<std::size_t>(row.i)];
  if (row.j < spheres) ++counts_[static_cast<std::size_t>(row.j)];  // else a wall
  ++done_;
}

}  // namespace zenosphere
