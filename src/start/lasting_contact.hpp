#pragma once

#include <cstddef>
#include <optional>

#include "case/case.hpp"
#include "start/start_file.hpp"

namespace zenosphere {

/// A sphere that a start holds on a wall.
struct LastingContact {
  std::size_t sphere;
  bool is_pushed;  ///< by a wall that oscillates, not by gravity alone
};

/// The first sphere without a speed that gravity holds on a wall, or that a wall pushes which
/// oscillates and on which it may not rest; nothing if there is none.
///
/// Hard spheres meet in instants: in a contact that lasts there would be one after the other, and
/// the clock would never leave 0, however elastic they are.
std::optional<LastingContact> lasting_contact(const Case& values, const GivenStart& start);

}  // namespace zenosphere
