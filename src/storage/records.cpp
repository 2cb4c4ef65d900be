#include "storage/records.hpp"

#include "storage/checksum.hpp"

namespace zenosphere {
namespace {

template <class Action>
void for_each_column(CollisionRows& rows, Action action) {
  action(rows.k);
  action(rows.time);
  action(rows.i);
  action(rows.j);
  action(rows.gap);
  action(rows.normal_speed);
  action(rows.flags);
}

}  // namespace

void CollisionRows::reserve(std::size_t rows) {
  for_each_column(*this, [rows](auto& column) { column.reserve(rows); });
}

void CollisionRows::clear() {
  for_each_column(*this, [](auto& column) { column.clear(); });
}

Basis Basis::of(const Checkpoint& checkpoint) {
  return {checkpoint.collisions, checkpoint.log_rows, checkpoint.snapshots, checkpoint.state.size(),
          checksum(checkpoint.state)};
}

}  // namespace zenosphere
