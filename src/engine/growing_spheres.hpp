#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/calendar.hpp"
#include "model/random.hpp"
#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Spheres or disks of equal mass that grow in proportion while they fly and collide elastically.
///
/// Their motion is cut into rounds. At the start of one all spheres stand at the same time, are
/// brought to the same granular temperature, and list those that they can meet; the round ends
/// before a sphere has left the margin of its list. Within a round a sphere has one event at a
/// time: the earliest that was in sight when it changed last. Where the partner has changed since,
/// the event only makes it look again.
///
/// The unit of time is that in which the thermal speed covers a mean diameter.
/// Source: Lubachevsky & Stillinger, J. Stat. Phys. 60 (1990) 561; one event a sphere, Lubachevsky,
/// J. Comput. Phys. 94 (1991) 255.
template <int Dim>
class GrowingSpheres {
 public:
  /// Points at random places.
  /// \param diameters  N, > 0: those of full size
  GrowingSpheres(std::span<const double> diameters, const ShearBox<Dim, double>& box,
                 Random& random);

  /// What a round was like.
  struct Round {
    double time;  ///< that it took
    double collisions_per_sphere;
  };

  /// Flies on for a round.
  /// \param rate      growth of the size per time
  /// \param full_size the round ends where the size has reached it
  Round advance(double rate, double full_size);

  /// Diameters now / those of full size.
  double size() const { return size_; }
  const std::vector<Vec<Dim, double>>& positions() const { return positions_; }

 private:
  struct Neighbour {
    std::int32_t sphere;
    Vec<Dim, double> shift;
  };
  /// What a sphere meets next: another one, a wall, or the end of its margin.
  struct Meeting {
    enum class Kind { nothing, sphere, lower_wall, upper_wall, margin };
    double time;
    Kind kind = Kind::nothing;
    std::int32_t partner = 0;
    std::int64_t partner_changes = 0;  ///< of the partner, up to the prediction
    Vec<Dim, double> shift{};          ///< of the partner's place
  };

  void rescale_velocities();
  void list_neighbours(double growth);
  void predict(std::int32_t i);
  void consider_sphere(std::int32_t i, const Neighbour& neighbour, Meeting& next) const;
  void consider_walls(std::int32_t i, Meeting& next) const;
  void consider_margin(std::int32_t i, Meeting& next) const;
  void collide(std::int32_t i, const Meeting& meeting);
  void bounce(std::int32_t i, const Meeting& meeting);
  void bring_to_now(std::int32_t i);
  void wrap(std::int32_t i);

  double radius(std::int32_t i) const { return radii_[static_cast<std::size_t>(i)]; }
  Vec<Dim, double>& position(std::int32_t i) { return positions_[static_cast<std::size_t>(i)]; }
  Vec<Dim, double>& velocity(std::int32_t i) { return velocities_[static_cast<std::size_t>(i)]; }
  const Vec<Dim, double>& velocity(std::int32_t i) const {
    return velocities_[static_cast<std::size_t>(i)];
  }
  Vec<Dim, double> position_now(std::int32_t i) const {
    const auto k = static_cast<std::size_t>(i);
    return positions_[k] + velocities_[k] * (now_ - times_[k]);
  }
  std::int32_t count() const { return static_cast<std::int32_t>(radii_.size()); }

  ShearBox<Dim, double> box_;
  std::vector<double> radii_;  ///< of full size
  double mean_diameter_;
  double margin_;
  std::vector<Vec<Dim, double>> positions_;  ///< at times_
  std::vector<Vec<Dim, double>> velocities_;
  double size_ = 0;  ///< at the start of the round

  double now_ = 0;   ///< since the start of the round
  double rate_ = 0;  ///< of the growth
  std::vector<double> times_;
  std::vector<Vec<Dim, double>> places_before_;  ///< places at the start of the round
  std::vector<std::size_t> first_neighbour_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::int64_t> changes_;
  std::vector<Meeting> meetings_;
  Calendar<double> calendar_;
};

}  // namespace zenosphere
