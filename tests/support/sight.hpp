#pragma once

#include "engine/contacts_ahead.hpp"
#include "engine/sphere.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"

namespace zenosphere::support {

/// How a sphere that flies straight moves, as seen from somewhere in one of its images: by the
/// operations of the engine, in their order.
template <int Dim, class Real>
RelativeMotion<Dim, Real> motion_seen(const Viewpoint<Dim, Real>& from,
                                      const Sphere<Dim, Real>& sphere, Image<Dim, Real> image) {
  image.position[0] += image.velocity * from.when;
  const auto place = sphere.position + sphere.velocity * (from.when - sphere.time);
  RelativeMotion<Dim, Real> motion{(place - from.position) + image.position,
                                   sphere.velocity - from.velocity};
  motion.dv[0] += image.velocity;
  return motion;
}

}  // namespace zenosphere::support
