#pragma once

#include <cmath>

#include "engine/contacts_ahead.hpp"
#include "engine/sphere.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// A floating-point filter: a sphere in double, which rules out contacts of spheres that have more
/// digits. What it rules out is ruled out for sure.
///
/// Most neighbours part from a sphere, or pass it by far. Their first digits say so, which cost
/// little beside a hundred. The errors of leaving out the others, and of rounding, are carried
/// along as bounds; a pair for which they leave a contact possible is left to contact().
template <int Dim>
class FloatingPointFilter {
 public:
  template <class Real>
  explicit FloatingPointFilter(const Viewpoint<Dim, Real>& exact)
      : from_{rough(exact.position), rough(exact.velocity), static_cast<double>(exact.when)} {}

  /// Whether contact() lets no sphere touch this one, which flies straight; false: look closer.
  ///
  /// \param image  in which the sphere is seen, at remainder 0
  /// \param sigma  mean diameter of the two
  template <class Real>
  bool misses(const Sphere<Dim, Real>& sphere, const Image<Dim, Real>& image,
              double sigma = 1) const {
    const Vec<Dim, double> position = rough(sphere.position);
    const Vec<Dim, double> velocity = rough(sphere.velocity);
    const auto time = static_cast<double>(sphere.time);
    const Vec<Dim, double> shift = rough(image.position);
    const auto slide = static_cast<double>(image.velocity);
    const double slid = slide * from_.when;
    RelativeMotion<Dim, double> motion = {
        position + velocity * (from_.when - time) - from_.position + shift,
        velocity - from_.velocity};
    motion.dr[0] += slid;
    motion.dv[0] += slide;
    // Each error is a small part of the numbers that have been added up.
    const double times = std::abs(from_.when) + std::abs(time);
    const double places = size(position) + size(velocity) * times + size(from_.position) +
                          size(shift) + std::abs(slid);
    const double velocities = size(velocity) + size(from_.velocity) + std::abs(slide);
    return is_sure(approach(motion), unit * (places + (sigma != 1) * sigma),
                   unit * velocities + least, sigma);
  }

 private:
  static constexpr double unit = 1e-15;    ///< more than all roundings of one number, relatively
  static constexpr double least = 1e-300;  ///< numbers that are much smaller have fewer digits

  template <class Real>
  static Vec<Dim, double> rough(const Vec<Dim, Real>& exact) {
    Vec<Dim, double> rough;
    for (int axis = 0; axis < Dim; ++axis) rough[axis] = static_cast<double>(exact[axis]);
    return rough;
  }

  /// Not less than the length.
  static double size(const Vec<Dim, double>& vector) {
    double sum = 0;
    for (int axis = 0; axis < Dim; ++axis) sum += std::abs(vector[axis]);
    return sum;
  }

  /// Whether two that are seen like this part, or pass each other, even if dr and dv are off by as
  /// much as this.
  static bool is_sure(const Approach<double>& seen, double dr_error, double dv_error,
                      double sigma) {
    const double distance = std::sqrt(seen.r2);
    const double speed = std::sqrt(seen.v2);
    const double b_error =
        (distance + dr_error) * dv_error + speed * dr_error + unit * distance * speed;
    if (seen.b > b_error) return true;
    const double least_distance = distance - dr_error;
    const double least_speed = speed - dv_error;
    if (!(least_distance > sigma && least_speed > 1e-140)) return false;  // squares have all digits
    const double most_b = std::abs(seen.b) + b_error;
    // The discriminant of contact() is negative if b^2 < v2 (r2 - sigma^2).
    const double least_c = (least_distance - sigma) * (least_distance + sigma);
    return most_b * most_b < (1 - 1e-9) * (least_speed * least_speed * least_c);
  }

  Viewpoint<Dim, double> from_;
};

}  // namespace zenosphere
