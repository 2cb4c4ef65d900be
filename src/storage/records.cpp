#include "storage/records.hpp"

#include "storage/checksum.hpp"

namespace zenosphere {
void CollisionRows::reserve(std::size_t rows) {
  fields(*this, [rows](const char*, auto& column, auto) { column.reserve(rows); });
}

void CollisionRows::clear() {
  fields(*this, [](const char*, auto& column, auto) { column.clear(); });
}

Basis Basis::of(const Checkpoint& checkpoint) {
  return {checkpoint.collisions, checkpoint.log_rows, checkpoint.snapshots, checkpoint.state.size(),
          checksum(checkpoint.state)};
}

}  // namespace zenosphere
