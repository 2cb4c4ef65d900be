#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/configuration.hpp"
#include "engine/contacts_ahead.hpp"
#include "engine/floating_point_filter.hpp"
#include "engine/huge_page_vector.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/prefetching.hpp"
#include "engine/simd/first_contacts.hpp"
#include "engine/sliding_box.hpp"
#include "engine/sphere.hpp"
#include "model/archive.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The spheres in their box: where each one is at any moment between two events, and how another
/// one sees it from there.
///
/// Every sphere is stored as it was at its own last event; `when` is always a remainder of the
/// clock. Positions are box coordinates, x in the frame of the layer of the sphere's cell. A sphere
/// keeps its cell and its frame until it is given another one, also where it is outside of the cell
/// or of the box. Nothing in here knows about collisions or the order of events, nor which spheres
/// are near (see NeighbourSearch).
template <int Dim, class Real>
class Spheres {
 public:
  using Vector = Vec<Dim, Real>;
  using Sphere = zenosphere::Sphere<Dim, Real>;

  /// Puts each sphere into the cell of its place, at remainder 0.
  ///
  /// Throws std::invalid_argument where cells are not wide enough for the largest sphere.
  ///
  /// \param acceleration  of every sphere that is not immobile, diameters/time^2
  Spheres(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
          const Vector& acceleration);

  /// Spheres in the state that an archive holds. Throws ArchiveError where that cannot be.
  Spheres(const ShearBox<Dim, Real>& box, const Vector& acceleration, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const;

  // Compiled once, like those of a simulation.
  Spheres(const Spheres&);
  Spheres(Spheres&&) noexcept;
  ~Spheres();

  std::int32_t count() const { return static_cast<std::int32_t>(spheres_.size()); }
  Sphere& operator[](std::int32_t i) { return spheres_[static_cast<std::size_t>(i)]; }
  const Sphere& operator[](std::int32_t i) const { return spheres_[static_cast<std::size_t>(i)]; }
  const ShearBox<Dim, Real>& box() const { return sliding_box_.box(); }
  const SlidingBox<Dim, Real>& sliding_box() const { return sliding_box_; }
  const SlidingCells<Dim>& cells() const { return sliding_box_.cells(); }
  /// The cell of a sphere.
  Steps<Dim> home(std::int32_t i) const { return cells().coordinates((*this)[i].cell); }

  /// What they are, and how fast they turn: of each, or of none where they do not turn.
  const Grains<Real>& grains() const { return grains_; }
  std::vector<Spin<Dim, Real>>& spins() { return spins_; }
  const std::vector<Spin<Dim, Real>>& spins() const { return spins_; }

  /// Whether all have unit diameter.
  bool are_of_one_size() const { return radii_.empty(); }
  /// Half the diameters, of none where all have unit diameter.
  const std::vector<Real>& radii() const { return radii_; }
  /// Distance of the centres of two spheres in contact: their mean diameter.
  Real sigma(std::int32_t i, std::int32_t j) const {
    return are_of_one_size() ? Real(1) : Real(radius(i) + radius(j));
  }
  const Real& largest_diameter() const { return largest_; }

  const Vector& acceleration() const { return acceleration_; }
  /// Whether there is no acceleration.
  bool fly_straight() const { return !fall_; }
  /// Whether there is one, and some spheres are immobile.
  bool some_are_held() const { return some_are_held_; }
  /// Whether one of two spheres falls and the other does not: ways between them are not straight.
  bool fall_apart(std::int32_t i, std::int32_t j) const {
    return some_are_held_ && grains_.is_immobile(i) != grains_.is_immobile(j);
  }
  /// Acceleration of a sphere, diameters/time^2.
  Vector pull(std::int32_t i) const { return falls(i) ? acceleration_ : Vector{}; }

  /// Inlined also where GCC has no room left for it: every prediction calls it.
  [[gnu::always_inline]] Vector position_at(std::int32_t i, const Real& when) const {
    const Sphere& sphere = (*this)[i];
    const Real flight = when - sphere.time;
    Vector position = sphere.position + sphere.velocity * flight;
    if (falls(i)) [[unlikely]]
      position += acceleration_ * (flight * flight / 2);
    return position;
  }
  [[gnu::always_inline]] Vector velocity_at(std::int32_t i, const Real& when) const {
    const Sphere& sphere = (*this)[i];
    if (!falls(i)) [[likely]]
      return sphere.velocity;
    return sphere.velocity + acceleration_ * (when - sphere.time);
  }

  /// A sphere as it is at `when`.
  Sphere copy_at(std::int32_t i, const Real& when) const {
    Sphere copy = (*this)[i];
    fly(copy, i, when);
    return copy;
  }
  /// Stores a sphere as it is at `when`.
  void advance(std::int32_t i, const Real& when) { fly((*this)[i], i, when); }

  /// Motion of a neighbour relative to i at `when`.
  RelativeMotion<Dim, Real> motion(std::int32_t i, Neighbour neighbour, const Real& when) const {
    return motion_from(viewpoint(i, when), neighbour);
  }
  /// The same, where both have been advanced to `when`.
  RelativeMotion<Dim, Real> motion_as_stored(std::int32_t i, Neighbour neighbour,
                                             const Real& when) const {
    const Sphere& own = (*this)[i];
    const Sphere& other = (*this)[neighbour.sphere()];
    return in_image(neighbour, when,
                    {other.position - own.position, other.velocity - own.velocity});
  }
  /// How i sees j in the nearest of all images that lead from one layer to the other.
  Neighbour nearest_image(std::int32_t i, std::int32_t j, const Real& when) const;
  /// Square of the distance in which i sees a neighbour, diameters^2.
  Real square_of_distance(std::int32_t i, Neighbour neighbour, const Real& when) const {
    const Vector dr = motion(i, neighbour, when).dr;
    return dot(dr, dr);
  }

  /// The first two contacts of i with these neighbours, where they can be found without a look at
  /// each; otherwise nothing, and find_contacts() tells.
  std::optional<FirstContacts<Real>> first_contacts(std::int32_t i,
                                                    std::span<const Neighbour> neighbours,
                                                    const Real& when) const {
    if constexpr (std::is_same_v<Real, double>) {
      if (lanes_are_wide_) {
        const Viewpoint<Dim, double> here = viewpoint(i, when);
        const Image<Dim, double>* const images = sliding_box_.images();
        if (are_of_one_size()) [[likely]]
          return first_contacts_wide(spheres_.data(), neighbours, images, here);
        return first_contacts_wide(spheres_.data(), neighbours, images, here, radii_.data(), i);
      }
    }
    return std::nullopt;
  }

  /// Adds the contacts of i with these neighbours, counted from `when`.
  void find_contacts(std::int32_t i, std::span<const Neighbour> neighbours, const Real& when,
                     ContactsAhead<Real>& ahead) const {
    const bool is_mixture = !are_of_one_size() || !grains_.immobile.empty();
    if (is_mixture) return find_contacts_in_mixture(i, neighbours, when, ahead);
    find_contacts_of_unit_spheres(i, neighbours, when, ahead);
  }

  /// Prefetches what is stored of a sphere.
  void prefetch(std::int32_t i) const { prefetch_line(&(*this)[i]); }

  /// Gives a sphere the cell of the place `ahead` of where it is at `when`, and the frame of that
  /// cell's layer. It stays stored for the time for which it was: only where it is given another
  /// layer or image of the box is it rounded.
  ///
  /// \return  the periodic image in which that is seen
  PeriodicImage go_home(std::int32_t i, const Real& when, const Vector& ahead);
  /// Gives a sphere another cell.
  ///
  /// \param periodic_image  in which that cell is seen
  void enter(std::int32_t i, std::int32_t cell, PeriodicImage periodic_image) {
    Sphere& sphere = (*this)[i];
    sphere.cell = cell;
    if (periodic_image == PeriodicImage()) return;
    sliding_box_.see_from(sphere, periodic_image);
    boxes(i) += SlidingBox<Dim, Real>::periods_of(periodic_image);
  }

  /// Gives a sphere the image of the box to which it has come at `when`, however far that is. Not
  /// under shear. It stays stored for the time for which it was, and keeps its cell.
  void bring_back(std::int32_t i, const Real& when) {
    boxes(i) += sliding_box_.bring_back((*this)[i], position_at(i, when));
  }

  /// Whether two spheres are in the frame of one layer.
  bool share_layer(std::int32_t i, std::int32_t j) const {
    return SlidingCells<Dim>::layers(home(i)) == SlidingCells<Dim>::layers(home(j));
  }

  /// Shifts the times of all spheres by `span`; under shear that is one clock unit, and the
  /// layers have slid by one more cell.
  void shift_times(const Real& span);

  /// Velocity relative to the imposed profile at the sphere's place, diameters/time.
  Vector peculiar_velocity(std::int32_t i, const Real& when) const {
    Vector velocity = velocity_at(i, when);
    if (box().is_sheared())
      velocity[0] -= sliding_box_.profile_in_layer((*this)[i].cell, position_at(i, when));
    return velocity;
  }

  /// The state, wrapped into the box.
  ///
  /// \param units  whole clock units since the start
  Configuration<Dim, Real> configuration(double units, const Real& when) const;

 private:
  /// Spheres and what they are, as an archive has them.
  using Archived = std::pair<HugePageVector<Sphere>, Grains<Real>>;

  Spheres(HugePageVector<Sphere> spheres, Grains<Real> grains, const ShearBox<Dim, Real>& box,
          const Vector& acceleration);
  Spheres(Archived archived, const ShearBox<Dim, Real>& box, const Vector& acceleration,
          ArchiveReader& archive);
  void require_room() const;
  void place(const Configuration<Dim, Real>& start);
  void require_possible(const Sphere& sphere) const;
  void read_images(ArchiveReader& archive);
  void read_spins(ArchiveReader& archive);

  const Real& radius(std::int32_t i) const { return radii_[static_cast<std::size_t>(i)]; }
  /// Whether a sphere is accelerated. Where none is, that is one test.
  [[gnu::always_inline]] bool falls(std::int32_t i) const {
    return fall_ && !(some_are_held_ && grains_.is_immobile(i));
  }
  /// Moves the sphere i, or a copy of it, to where it is at `when`.
  void fly(Sphere& sphere, std::int32_t i, const Real& when) const {
    sphere.position = position_at(i, when);
    sphere.velocity = velocity_at(i, when);
    sphere.time = when;
  }
  Viewpoint<Dim, Real> viewpoint(std::int32_t i, const Real& when) const {
    return {position_at(i, when), velocity_at(i, when), when};
  }
  RelativeMotion<Dim, Real> motion_from(const Viewpoint<Dim, Real>& viewpoint,
                                        Neighbour neighbour) const {
    const std::int32_t other = neighbour.sphere();
    return in_image(neighbour, viewpoint.when,
                    {position_at(other, viewpoint.when) - viewpoint.position,
                     velocity_at(other, viewpoint.when) - viewpoint.velocity});
  }
  /// The motion of the image in which a neighbour is seen, from that of the neighbour itself.
  RelativeMotion<Dim, Real> in_image(Neighbour neighbour, const Real& when,
                                     RelativeMotion<Dim, Real> motion) const {
    const Image<Dim, Real>& image = sliding_box_.image(neighbour.periodic_image());
    // Number by number: a moved image would be written in parts and read as a whole, with a wait.
    motion.dr[0] += image.position[0] + image.velocity * when;
    for (int axis = 1; axis < Dim; ++axis) motion.dr[axis] += image.position[axis];
    motion.dv[0] += image.velocity;
    return motion;
  }
  void find_contacts_of_unit_spheres(std::int32_t i, std::span<const Neighbour> neighbours,
                                     const Real& when, ContactsAhead<Real>& ahead) const;
  void find_contacts_in_mixture(std::int32_t i, std::span<const Neighbour> neighbours,
                                const Real& when, ContactsAhead<Real>& ahead) const;
  Vec<Dim, double>& boxes(std::int32_t i) { return boxes_[static_cast<std::size_t>(i)]; }

  SlidingBox<Dim, Real> sliding_box_;
  Vector acceleration_;
  bool fall_;            ///< the acceleration is not zero
  bool some_are_held_;   ///< and some are immobile
  bool lanes_are_wide_;  ///< contacts are found four at a time
  Grains<Real> grains_;
  std::vector<Spin<Dim, Real>> spins_;
  Real largest_;             ///< diameter
  std::vector<Real> radii_;  ///< empty where all have unit diameter
  HugePageVector<Sphere> spheres_;
  HugePageVector<Vec<Dim, double>> boxes_;  ///< of each sphere: faces that it has come through
};

}  // namespace zenosphere
