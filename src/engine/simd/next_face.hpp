#pragma once

#include <array>
#include <limits>

#include "engine/sphere.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Through which face a sphere leaves its cell.
template <class Real>
struct NextFace {
  Real time;      ///< from now, >= 0; infinity: it stays
  int axis;       ///< the lowest where several faces are reached at once
  int direction;  ///< 0: it stays
};

/// The widths of a cell, diameters: four can be read.
template <class Real>
using CellWidths = std::array<Real, 4>;

/// The first face ahead of a sphere at `when`.
template <int Dim, class Real>
NextFace<Real> next_face(const Sphere<Dim, Real>& sphere, const Steps<Dim>& cell,
                         const CellWidths<Real>& widths, const Real& when) {
  Real first = std::numeric_limits<Real>::infinity();
  NextFace<Real> next{first, 0, 0};
  for (int axis = 0; axis < Dim; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Real& velocity = sphere.velocity[axis];
    if (velocity == 0) continue;
    const Real place = sphere.position[axis] + velocity * (when - sphere.time);
    const Real in_cell = place - cell[a] * widths[a];
    const Real time = ((velocity > 0 ? widths[a] : Real(0)) - in_cell) / velocity;
    if (time < first) {
      first = time;
      next = {time > 0 ? time : Real(0), axis, velocity > 0 ? 1 : -1};
    }
  }
  return next;
}

/// The same operations along all axes at once. Only where has_wide_lanes().
///
/// Which face it is, is as good as random: a processor would guess wrong at every other branch.
template <int Dim>
NextFace<double> next_face_wide(const Sphere<Dim, double>& sphere, const Steps<Dim>& cell,
                                const CellWidths<double>& widths, double when);

}  // namespace zenosphere
