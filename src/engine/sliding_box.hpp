#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/periodic_image.hpp"
#include "engine/sliding_cells.hpp"
#include "engine/sphere.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// A box whose layers of cells slide: in which cell, frame and periodic image a place is, and how
/// it is seen from another one.
///
/// Places are box coordinates, x in the frame of the layer. Times named `when` are remainders of
/// the clock: at 0 the layers have slid by whole cells. The images of the box along y may be
/// displaced at the start already; the layers slide from 0 on, so that places are kept as they are
/// given. Nothing in here knows about the motion of spheres, or about neighbours.
template <int Dim, class Real>
class SlidingBox {
 public:
  using Vector = Vec<Dim, Real>;
  using Sphere = zenosphere::Sphere<Dim, Real>;

  explicit SlidingBox(const ShearBox<Dim, Real>& box);

  const ShearBox<Dim, Real>& box() const { return box_; }
  const SlidingCells<Dim>& cells() const { return cells_; }

  /// Displacement of the upper image of the box along x at the start, diameters.
  const Real& offset() const { return offset_; }
  bool has_displaced_images() const { return offset_ != 0; }
  /// Displaces the images; to be called before anything else.
  ///
  /// \param offset  0 in one dimension, and where the box is closed along x or y
  void displace_images(const Real& offset);

  /// Every layer has slid by one more cell against the one below it.
  void slide_by_one_cell();
  /// They have slid by so many.
  void slide_to(int whole_cells);

  /// What is added to the coordinates of a neighbour that is seen in a periodic image, at remainder
  /// 0.
  const Image<Dim, Real>& image(PeriodicImage periodic_image) const {
    return images_[static_cast<std::size_t>(periodic_image.code())];
  }
  /// The same of all, by their codes.
  const Image<Dim, Real>* images() const { return images_.data(); }

  /// The lower corner of a cell, diameters.
  Vector corner(std::int32_t cell) const {
    const Steps<Dim> coordinates = cells_.coordinates(cell);
    Vector corner;
    for (int axis = 0; axis < Dim; ++axis) {
      corner[axis] = coordinates[static_cast<std::size_t>(axis)] * box_.cell_width()[axis];
    }
    return corner;
  }

  /// A cell, and the image in which it is seen from the frame in which a place was given.
  struct Home {
    std::int32_t cell;
    PeriodicImage periodic_image;
  };
  /// The cell of a place at `when`.
  ///
  /// \param place  in the frame of the cell `from`: in its layer or the next one
  Home home(const Vector& place, std::int32_t from, const Real& when) const;

  /// Gives a sphere the frame and the box of a periodic image. It stays stored for the time for
  /// which it was, and is rounded.
  void see_from(Sphere& sphere, PeriodicImage periodic_image) const;

  /// Brings a sphere, however far outside of the box, back along the axes that are periodic. Not
  /// under shear.
  ///
  /// \param place  where it is
  /// \return  through how many boxes it has come
  Vec<Dim, double> bring_back(Sphere& sphere, const Vector& place) const;

  /// By how much of a cell the layers beside a cell have slid, with the displacement of images
  /// beyond the faces of the box; both beside whole cells, in [0, 2].
  LayerSlides slides(const Steps<Dim>& home, const Real& when) const;

  /// The shortest of the periodic images of a displacement at `when`, axis by axis.
  Vector shortest_image(Vector displacement, const Real& when) const;

  /// The imposed velocity at a place in the frame of its layer, diameters/time.
  Real profile_in_layer(std::int32_t cell, const Vector& place) const {
    if constexpr (Dim == 1) {
      return 0;
    } else {
      if (!box_.is_sheared()) return 0;
      const Real middle = (cells_.coordinates(cell)[1] + Real(0.5)) * box_.cell_width()[1];
      return box_.shear_rate() * (place[1] - middle);
    }
  }

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  ///
  /// \param units  whole clock units since the start
  Real lees_edwards_offset(double units, const Real& when) const;

  /// A place in the laboratory, in the box; and through how many boxes that is.
  struct Place {
    Vector in_box;
    Vec<Dim, double> boxes{};
  };
  /// Where a place in the frame of a layer is in the laboratory.
  ///
  /// \param layer  from 0
  /// \param boxes  through how many boxes it has come, as they are counted here
  Place in_laboratory(Vector place, int layer, Vec<Dim, double> boxes, double units,
                      const Real& when) const;

  /// Through how many boxes a periodic image leads.
  static Vec<Dim, double> periods_of(PeriodicImage periodic_image) {
    Vec<Dim, double> periods;
    for (int axis = 0; axis < Dim; ++axis) periods[axis] = periodic_image.periods(axis);
    return periods;
  }

 private:
  void find_images();
  Real slide(double units, const Real& when) const;
  Real turned_offset(const Real& when) const;
  double boxes_slid(double layer, double units) const;
  void wrap(Place& place) const;

  ShearBox<Dim, Real> box_;
  SlidingCells<Dim> cells_;
  Real offset_ = 0;
  double odd_offset_ = 0;  ///< of it the part beside whole cells, in cells
  std::array<Image<Dim, Real>, 256> images_{};
};

}  // namespace zenosphere
