#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/shear_box.hpp"

namespace zenosphere {

/// The periodic image in which a sphere sees a neighbour: through which faces of the box, and how
/// many layers up or down. In one number below `count`, so that it fits beside a sphere's number.
class PeriodicImage {
 public:
  static constexpr std::int32_t count = 7 * 3 * 3 * 3;

  constexpr PeriodicImage() = default;
  /// \param periods  boxes crossed along each axis; along x at most 3 either way, else 1
  /// \param layers   -1, 0 or +1
  template <std::size_t Dim>
  constexpr PeriodicImage(const std::array<int, Dim>& periods, int layers)
      : code_((count - 1) / 2 + per_period[0] * periods[0] + layers) {
    for (std::size_t axis = 1; axis < Dim; ++axis) code_ += per_period[axis] * periods[axis];
  }
  static PeriodicImage from_code(std::int32_t code) {
    PeriodicImage periodic_image;
    periodic_image.code_ = code;
    return periodic_image;
  }

  constexpr std::int32_t code() const { return code_; }
  int layers() const { return code_ % 3 - 1; }
  int periods(int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return axis == 0 ? code_ / per_period[a] - 3 : code_ / per_period[a] % 3 - 1;
  }

  /// The same, but through so many more faces normal to z.
  PeriodicImage beyond_z(int periods) const { return from_code(code_ + per_period[2] * periods); }

  /// That in which the neighbour sees the sphere.
  PeriodicImage reversed() const { return from_code(count - 1 - code_); }

  /// The same once the layers have slid by a whole box, counted from zero again.
  PeriodicImage after_whole_turn() const { return from_code(code_ + per_period[0] * layers()); }

  friend bool operator==(const PeriodicImage&, const PeriodicImage&) = default;

 private:
  static constexpr std::array<std::int32_t, 3> per_period{27, 9, 3};

  std::int32_t code_ = (count - 1) / 2;  // no face, the same layer
};

}  // namespace zenosphere
