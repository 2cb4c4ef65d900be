#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "case/case.hpp"
#include "model/archive.hpp"
#include "model/errors.hpp"
#include "storage/records.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// What the state of a checkpoint holds; to be raised whenever that changes.
inline constexpr std::uint32_t checkpoint_version = 15 + log_version;

/// Begins the state of a checkpoint.
template <int Dim, class Real>
void write_state_head(ArchiveWriter& archive) {
  archive(checkpoint_version, std::int32_t{Dim}, std::int32_t{significand_bits<Real>()});
}

/// Reads the beginning of a state. A state in fewer digits than Real has is promoted.
///
/// Throws InputError for a version that this program does not read, ArchiveError for a state that
/// does not belong to the case.
template <int Dim, class Real>
void require_known_state(const Case& values, const RecoveredOutput& output, ArchiveReader& state) {
  const auto version = state.next<std::uint32_t>();
  if (version != checkpoint_version) {
    throw InputError(fmt::format(
        "{}: has a checkpoint of version {} (this program reads {}); resume it with zenosphere {} "
        "({}), which wrote it",
        output.path.string(), version, checkpoint_version, output.info.program_version,
        output.info.git_hash));
  }
  const auto dimension = state.next<std::int32_t>();
  const auto bits = state.next<std::int32_t>();
  require_archived(
      dimension == Dim && bits <= significand_bits<Real>() && is_precision_of_bits(bits),
      "the state of another kind of run");
  if (bits < significand_bits<Real>()) state.promote_from(bits);
  // A sphere takes more than 32 bytes: one that the case only claims gets no memory.
  require_archived(state.left() / 32 >= static_cast<std::size_t>(values.system.spheres),
                   "the state of another number of spheres");
}

}  // namespace zenosphere
