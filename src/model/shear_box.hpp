#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "model/vec.hpp"

namespace zenosphere {

/// A number of whole cells along each axis.
template <int Dim>
using Steps = std::array<int, Dim>;

/// No cell is narrower, in diameters, unless it is alone between walls: a sphere needs some room in
/// its cell before it has to look for neighbours again.
inline constexpr double narrowest_cell = 1.01;

/// What a side must be longer than, in diameters: two cells, or a sphere between walls.
inline constexpr double least_side(bool is_closed) {
  return is_closed ? 1 + 1e-9 : 2 * narrowest_cell;
}

/// A shift of position and velocity at once: what must be added to the stored coordinates of a
/// sphere in one cell to see it from another cell. In double, four numbers can be read of each.
template <int Dim, class Real>
struct alignas(32) Image {
  Vec<Dim, Real> position;  ///< diameters
  Real velocity;            ///< along the flow direction x, diameters/time
};

/// The periodic box, cut into cells whose layers slide with the mean flow.
///
/// Flow along x (axis 0), gradient along y (axis 1). Every layer of cells has its own frame, which
/// moves with the mean velocity of the layer's mid-plane. Adjacent layers slide at the same speed
/// everywhere, also across the periodic boundary, so that no face is special. In one clock unit the
/// slide grows by one cell.
template <int Dim, class Real>
class ShearBox {
 public:
  /// \param sides       lengths of the box, diameters, each > least_side()
  /// \param shear_rate  1/time, >= 0; zero in one dimension
  /// \param least_width width that cells should have at least, diameters
  /// \param closed_axis the axis that ends at walls instead of being periodic, or none
  /// Throws std::invalid_argument where a sphere could meet two images of another at once.
  ShearBox(const Vec<Dim, Real>& sides, const Real& shear_rate, const Real& least_width = 1.5,
           std::optional<int> closed_axis = std::nullopt)
      : sides_(sides), shear_rate_(shear_rate), closed_axis_(closed_axis) {
    using std::floor;
    for (int axis = 0; axis < Dim; ++axis) {
      const int least = is_closed(axis) ? 1 : 2;
      if (!(sides[axis] > least_side(is_closed(axis))))
        throw std::invalid_argument("box too narrow");
      const Real margin = 1e-9;  // so that rounding makes no cell too narrow
      const Real width = least_width > narrowest_cell ? least_width : Real(narrowest_cell);
      const Real fitting = floor(static_cast<Real>(sides[axis] / (width * (1 + margin))));
      const int cells = fitting > least ? static_cast<int>(fitting) : least;
      cell_width_[axis] = sides[axis] / cells;
      // Beyond a wall lies a layer of cells that stays empty: no spheres meet across it.
      cells_[static_cast<std::size_t>(axis)] = is_closed(axis) ? cells + 1 : cells;
    }
    if constexpr (Dim > 1) slide_speed_ = shear_rate * cell_width_[1];
    clock_unit_ = is_sheared() ? Real(cell_width_[0] / slide_speed_) : Real(1);
  }

  const Vec<Dim, Real>& sides() const { return sides_; }
  const Vec<Dim, Real>& cell_width() const { return cell_width_; }
  const Steps<Dim>& cells() const { return cells_; }
  bool is_closed(int axis) const { return closed_axis_ == axis; }
  std::optional<int> closed_axis() const { return closed_axis_; }
  const Real& shear_rate() const { return shear_rate_; }
  bool is_sheared() const { return slide_speed_ > 0; }

  /// The imposed velocity along x at a place, diameters/time; the middle of the box is at rest.
  Real profile(const Vec<Dim, Real>& position) const {
    if constexpr (Dim == 1) return 0;
    return shear_rate_ * (position[Dim > 1 ? 1 : 0] - sides_[Dim > 1 ? 1 : 0] / 2);
  }

  /// Speed of a layer in the frame of the layer below it, diameters/time.
  const Real& slide_speed() const { return slide_speed_; }

  /// Time in which adjacent layers slide by one cell; without shear the case's time unit.
  const Real& clock_unit() const { return clock_unit_; }

  Real volume() const {
    Real product = 1;
    for (int axis = 0; axis < Dim; ++axis) product *= sides_[axis];
    return product;
  }

  /// How the coordinates of one cell are seen from another.
  ///
  /// \param lag         whole cells that the stored coordinates lack: a period where the way leads
  ///                    through a face of the box, and the whole slide between layers
  /// \param layers      steps between the two layers, -1, 0 or +1
  /// \param remainder   time since the slide was a whole number of cells; may be negative
  Image<Dim, Real> image(const Steps<Dim>& lag, int layers, const Real& remainder) const {
    Image<Dim, Real> image{{}, layers * slide_speed_};
    for (int axis = 0; axis < Dim; ++axis) {
      image.position[axis] = lag[static_cast<std::size_t>(axis)] * cell_width_[axis];
    }
    image.position[0] += layers * (slide_speed_ * remainder);
    return image;
  }

 private:
  Vec<Dim, Real> sides_;
  Vec<Dim, Real> cell_width_;
  Steps<Dim> cells_{};
  Real shear_rate_;
  std::optional<int> closed_axis_;
  Real slide_speed_ = 0;
  Real clock_unit_ = 1;
};

}  // namespace zenosphere
