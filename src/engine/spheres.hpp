#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/cell_search.hpp"
#include "engine/configuration.hpp"
#include "engine/contacts_ahead.hpp"
#include "engine/floating_point_filter.hpp"
#include "engine/huge_page_vector.hpp"
#include "engine/list_range.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/prefetching.hpp"
#include "engine/reference_cells.hpp"
#include "engine/simd/first_contacts.hpp"
#include "engine/sized_reference_cells.hpp"
#include "engine/sliding_cells.hpp"
#include "engine/sphere.hpp"
#include "model/archive.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The spheres in their box: where each one is at any moment between two events, and which are
/// near.
///
/// Every sphere is stored as it was at its own last event; `when` is always a remainder of the
/// clock. Positions are box coordinates, x in the frame of the sphere's layer.
///
/// Now and then the neighbour list of a sphere is rebuilt: it gets a reference position where it
/// is, or somewhat ahead, the cell of that position, and a list of all that can touch it while both
/// stay within reach of theirs. When it leaves that ball, or the layers have slid on by half a cell
/// or less, its list has to be rebuilt. Until then cell and frame stay, also where the sphere is a
/// little outside. In dilute systems there are neither reference positions nor lists (see
/// CellSearch): a sphere is put into the next cell when it crosses a face of its own. Nothing in
/// here knows about collisions or the order of events.
///
/// Source: neighbour lists in event-driven dynamics: Donev, Torquato & Stillinger, J. Comput. Phys.
/// 202 (2005) 737. That each is renewed alone, and the frames that slide, are ours.
template <int Dim, class Real>
class Spheres {
 public:
  using Vector = Vec<Dim, Real>;
  using Sphere = zenosphere::Sphere<Dim, Real>;

  /// Builds all lists at remainder 0. The offset of the start stays with the images of the box;
  /// the layers slide from 0 on, so that places are kept as they are given.
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
  const ShearBox<Dim, Real>& box() const { return box_; }
  const Vector& acceleration() const { return acceleration_; }

  /// What they are, and how fast they turn: of each, or of none where they do not turn.
  const Grains<Real>& grains() const { return grains_; }
  std::vector<Spin<Dim, Real>>& spins() { return spins_; }
  const std::vector<Spin<Dim, Real>>& spins() const { return spins_; }

  /// Whether all have unit diameter.
  bool are_of_one_size() const { return radii_.empty(); }
  /// Distance of the centres of two spheres in contact: their mean diameter.
  Real sigma(std::int32_t i, std::int32_t j) const {
    return are_of_one_size() ? Real(1) : Real(radius(i) + radius(j));
  }
  const Real& largest_diameter() const { return largest_; }

  /// Inlined also where GCC has no room left for it: every prediction calls it.
  [[gnu::always_inline]] Vector position_at(const Sphere& sphere, const Real& when) const {
    const Real flight = when - sphere.time;
    Vector position = sphere.position + sphere.velocity * flight;
    if (is_pulled(sphere)) [[unlikely]]
      position += acceleration_ * (flight * flight / 2);
    return position;
  }
  Vector velocity_at(const Sphere& sphere, const Real& when) const {
    if (!is_pulled(sphere)) return sphere.velocity;
    return sphere.velocity + acceleration_ * (when - sphere.time);
  }

  /// Whether one of two spheres falls and the other does not: ways between them are not straight.
  bool fall_apart(std::int32_t i, std::int32_t j) const {
    return some_are_held_ && grains_.is_immobile(i) != grains_.is_immobile(j);
  }
  /// Whether there are such.
  bool some_are_held() const { return some_are_held_; }

  /// Stores the sphere as it is at `when`.
  void advance(Sphere& sphere, const Real& when) const {
    sphere.position = position_at(sphere, when);
    sphere.velocity = velocity_at(sphere, when);
    sphere.time = when;
  }

  /// A sphere as it is at `when`.
  Sphere copy_at(std::int32_t i, const Real& when) const {
    Sphere copy = (*this)[i];
    copy.position = position_at((*this)[i], when);
    copy.velocity = velocity_at((*this)[i], when);
    copy.time = when;
    return copy;
  }

  /// How i sees j, a neighbour; in a narrow box, where several images of it are near, the nearest
  /// one.
  Neighbour neighbour(std::int32_t i, std::int32_t j, const Real& when) const;

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

  /// The shortest of the periodic images of a displacement between two spheres at `when`, axis by
  /// axis.
  Vector shortest_image(Vector displacement, const Real& when) const;

  std::span<const Neighbour> neighbours(std::int32_t i) const {
    return search_ ? search_->around(cells_, cells_.coordinates((*this)[i].cell)) : lists_.of(i);
  }

  /// The first two contacts of i with these neighbours, where they can be found without a look at
  /// each; otherwise nothing, and find_contacts() tells.
  std::optional<FirstContacts<Real>> first_contacts(std::int32_t i,
                                                    std::span<const Neighbour> neighbours,
                                                    const Real& when) const {
    if constexpr (std::is_same_v<Real, double>) {
      if (lanes_are_wide_) {
        const Viewpoint<Dim, double> here = viewpoint(i, when);
        if (are_of_one_size()) [[likely]]
          return first_contacts_wide(spheres_.data(), neighbours, images_.data(), here);
        return first_contacts_wide(spheres_.data(), neighbours, images_.data(), here, radii_.data(),
                                   i);
      }
    }
    return std::nullopt;
  }

  /// Adds the contacts of i with these neighbours, counted from `when`.
  void find_contacts(std::int32_t i, std::span<const Neighbour> neighbours, const Real& when,
                     ContactsAhead<Real>& ahead) const {
    if (is_mixture_) return find_contacts_of(i, neighbours, when, ahead);
    const Viewpoint<Dim, Real> here = viewpoint(i, when);
    const FloatingPointFilter<Dim> roughly(here);
    for (const Neighbour neighbour : neighbours) {
      if constexpr (!std::is_floating_point_v<Real>) {  // dear numbers
        const Sphere& other = (*this)[neighbour.sphere()];
        if (!falls_ && roughly.misses(other, image(neighbour.periodic_image()))) continue;
      }
      const auto contact = zenosphere::contact(motion_from(here, neighbour));
      if (contact) ahead.add(neighbour.sphere(), *contact);
    }
  }

  /// Prefetches what will be read of a sphere.
  void prefetch(std::int32_t i) const {
    prefetch_line(&(*this)[i]);
    if (!search_) lists_.prefetch(i);
  }
  /// Prefetches the cells around it, where its list will be rebuilt at `when`.
  void prefetch_cells(std::int32_t i, const Real& when) const;
  /// Prefetches its neighbours.
  void prefetch_neighbours(std::int32_t i) const {
    for (const Neighbour neighbour : neighbours(i)) prefetch_line(&(*this)[neighbour.sphere()]);
  }

  /// When the list of a sphere has to be rebuilt, as foreseen at `when`; of a time after `until`
  /// only that it is after it.
  Real rebuild_time(std::int32_t i, const Real& when, const Real& until) const;

  /// Rebuilds the neighbour list of a sphere at `when`.
  ///
  /// \param meeting  the next one, as far as is known: where its reference position should be
  /// \return  its new neighbours
  std::span<const Neighbour> rebuild_list(std::int32_t i, const Real& when, const Real& meeting);

  /// Puts a sphere that has not been followed for a while into the cell where it is, and rebuilds
  /// its list.
  void place_anew(std::int32_t i, const Real& when);

  /// Whether spheres are looked for cell by cell, without lists.
  bool looks_by_cells() const { return search_.has_value(); }
  /// Whether spheres come near when all times are shifted: new neighbours, which have to be looked
  /// at.
  bool slide_near() const { return search_ && box_.is_sheared(); }
  /// The spheres that i has to look at then; of each pair one is told.
  std::span<const Neighbour> slid_near(std::int32_t i) const {
    return search_->slid_near(cells_, cells_.coordinates((*this)[i].cell));
  }

  /// How far a sphere goes from its reference position, or from the middle of its cell, diameters.
  double reach() const { return list_range_.reach; }

  /// Whether a sphere is far outside of its ball: it was known that it would meet no other there.
  bool is_far_out(std::int32_t i, const Real& when) const;

  /// Gives a sphere the image of the box to which it has come at `when`, however far that is. Not
  /// under shear. It stays stored for the time for which it was, and its list has to be rebuilt
  /// then.
  void bring_back(std::int32_t i, const Real& when) { boxes(i) += brought_back((*this)[i], when); }

  /// Whether more spheres are near one than lists should hold that are as wide as the cells.
  bool is_crowded() const { return is_crowded_; }
  /// Rebuilds all lists, with balls for a crowd from now on.
  void rebuild_in_crowd(const Real& when);

  /// Whether two spheres are in the frame of one layer.
  bool share_layer(std::int32_t i, std::int32_t j) const;

  /// Shifts the times of all spheres by `span`; under shear that is one clock unit, and the
  /// layers have slid by one more cell.
  void shift_times(const Real& span);

  /// Velocity relative to the imposed profile at the sphere's place, diameters/time.
  Vector peculiar_velocity(const Sphere& sphere, const Real& when) const {
    Vector velocity = velocity_at(sphere, when);
    if (box_.is_sheared()) velocity[0] -= profile_in_layer(sphere, when);
    return velocity;
  }

  /// The state, wrapped into the box.
  ///
  /// \param units  whole clock units since the start
  Configuration<Dim, Real> configuration(double units, const Real& when) const;

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset(double units, const Real& when) const;

  /// Whether the images along y were displaced at the start.
  bool has_displaced_images() const { return offset_ != 0; }

 private:
  /// Cells by which the rows below and above are displaced against a layer, beside whole ones.
  struct Slides {
    double below;
    double above;
  };

  Spheres(HugePageVector<Sphere> spheres, Grains<Real> grains, const ShearBox<Dim, Real>& box,
          const Vector& acceleration);
  /// Spheres and what they are, as an archive has them.
  using Archived = std::pair<HugePageVector<Sphere>, Grains<Real>>;
  Spheres(Archived archived, const ShearBox<Dim, Real>& box, const Vector& acceleration,
          ArchiveReader& archive);
  void find_contacts_of(std::int32_t i, std::span<const Neighbour> neighbours, const Real& when,
                        ContactsAhead<Real>& ahead) const;
  std::span<Neighbour> without_immobile(std::span<Neighbour> neighbours) const;
  const Real& radius(std::int32_t i) const { return radii_[static_cast<std::size_t>(i)]; }
  void require_room() const;
  void displace_images(const Real& offset);
  void place(const Configuration<Dim, Real>& start);
  Vector displacement_of_reference(const Vector& velocity, const Real& flight) const;
  void put_reference(std::int32_t i, const Real& when, const Vector& ahead);
  ReferencePosition::Place place_in_cell(const Vector& place, std::int32_t cell) const;
  Vector corner(std::int32_t cell) const;
  bool is_crowd_in_a_cell() const;
  PeriodicImage go_home(Sphere& sphere, const Real& when, const Vector& ahead) const;
  void see_from(Sphere& sphere, PeriodicImage periodic_image) const;
  /// Through which face a sphere leaves its cell.
  struct Exit {
    Real time = std::numeric_limits<Real>::infinity();  ///< from now
    int axis = 0;
    int direction = 0;  ///< 0: it stays
  };
  Exit exit(const Sphere& sphere, const Vector& in_cell) const;
  Real exit_at(std::int32_t i, const Real& when, const Real& until) const;
  Vector place_in_own_cell(const Sphere& sphere, const Real& when) const;
  std::span<const Neighbour> cross_face(std::int32_t i, const Real& when);
  int column_beyond(const Sphere& sphere, const Steps<Dim>& from, int layers, int periods,
                    const Real& when) const;
  void use_cells();
  void use_lists();
  Vec<Dim, double> brought_back(Sphere& sphere, const Real& when) const;
  void insert_reference(std::int32_t i);
  void remove_reference(std::int32_t i);
  std::span<Neighbour> neighbours_of(std::int32_t i, const Real& when);
  std::span<Neighbour> neighbours_of_one_size(std::int32_t i, const Real& when);
  std::span<Neighbour> neighbours_by_size(std::int32_t i, const Real& when);
  typename SizedReferenceCells<Dim>::Viewer viewer(std::int32_t i, const Steps<Dim>& home,
                                                   const ReferencePosition::Place& place,
                                                   const Real& when) const;
  Slides slides(const Steps<Dim>& home, const Real& when) const;
  /// The same in grains, in the middle of the time for which a list lasts.
  struct SlidGrains {
    std::array<int, 3> layers;  ///< below, beside and above: where they are along x
    int either_way;             ///< how far adjacent ones slide before and after that
  };
  SlidGrains slid_grains(const Slides& slid) const;
  typename SlidingCells<Dim>::Reach columns_within_reach(double place, const Slides& slid) const;
  void find_images();
  Real time_in_ball(const Vector& away, const Vector& velocity) const;
  Real time_in_cube(const Vector& away, const Vector& velocity, const Vector& pull) const;
  /// Half the side of the cube inside the ball that is within reach, diameters.
  double reach_along_axes() const { return list_range_.reach / std::sqrt(double{Dim}); }
  Neighbour not_listed_first(std::int32_t i, std::int32_t j, const Real& when) const;
  Neighbour nearest_image(std::int32_t i, std::int32_t j, const Real& when) const;
  Real square(std::int32_t i, Neighbour neighbour, const Real& when) const;
  void require_possible(const Sphere& sphere) const;
  void read_images(ArchiveReader& archive);
  void read_spins(ArchiveReader& archive);
  /// Whether gravity pulls a sphere.
  bool is_pulled(const Sphere& sphere) const {
    return falls_ && (!some_are_held_ || !is_held(sphere));
  }
  /// Whether a sphere is immobile. A copy that is not stored here is not: it is made of a sphere as
  /// it is now, and does not fly. Not inlined, so that it costs nothing where all fall.
  [[gnu::noinline, gnu::cold]] bool is_held(const Sphere& sphere) const {
    const auto i = static_cast<std::size_t>(&sphere - spheres_.data());
    return i < spheres_.size() && grains_.immobile[i] != 0;
  }
  /// Of gravity on a sphere, diameters/time^2.
  Vector pull(const Sphere& sphere) const { return is_pulled(sphere) ? acceleration_ : Vector{}; }
  Viewpoint<Dim, Real> viewpoint(std::int32_t i, const Real& when) const {
    return {position_at((*this)[i], when), velocity_at((*this)[i], when), when};
  }
  RelativeMotion<Dim, Real> motion_from(const Viewpoint<Dim, Real>& viewpoint,
                                        Neighbour neighbour) const {
    const Sphere& other = (*this)[neighbour.sphere()];
    return in_image(neighbour, viewpoint.when,
                    {position_at(other, viewpoint.when) - viewpoint.position,
                     velocity_at(other, viewpoint.when) - viewpoint.velocity});
  }
  /// The motion of the image in which a neighbour is seen, from that of the neighbour itself.
  RelativeMotion<Dim, Real> in_image(Neighbour neighbour, const Real& when,
                                     RelativeMotion<Dim, Real> motion) const {
    const Image<Dim, Real>& image = this->image(neighbour.periodic_image());
    // Number by number: a moved image would be written in parts and read as a whole, with a wait.
    motion.dr[0] += image.position[0] + image.velocity * when;
    for (int axis = 1; axis < Dim; ++axis) motion.dr[axis] += image.position[axis];
    motion.dv[0] += image.velocity;
    return motion;
  }
  const Image<Dim, Real>& image(PeriodicImage periodic_image) const {
    return images_[static_cast<std::size_t>(periodic_image.code())];
  }
  Real profile_in_layer(const Sphere& sphere, const Real& when) const;
  Real slide(double units, const Real& when) const;
  void turn();
  void wrap(Vector& position, Vec<Dim, double>& boxes) const;
  Real turned_offset(const Real& when) const;
  double boxes_slid(double layer, double units) const;
  static Vec<Dim, double> periods_of(PeriodicImage periodic_image) {
    Vec<Dim, double> periods;
    for (int axis = 0; axis < Dim; ++axis) periods[axis] = periodic_image.periods(axis);
    return periods;
  }
  Vec<Dim, double>& boxes(std::int32_t i) { return boxes_[static_cast<std::size_t>(i)]; }

  ReferencePosition& reference(std::int32_t i) { return lists_.reference(i); }
  const ReferencePosition& reference(std::int32_t i) const { return lists_.reference(i); }

  ShearBox<Dim, Real> box_;
  SlidingCells<Dim> cells_;
  Vector acceleration_;
  bool falls_;           ///< the acceleration is not zero
  bool some_are_held_;   ///< and some are immobile
  bool lanes_are_wide_;  ///< contacts are found four at a time
  Grains<Real> grains_;
  std::vector<Spin<Dim, Real>> spins_;
  Real largest_;             ///< diameter
  std::vector<Real> radii_;  ///< empty where all have unit diameter
  bool is_mixture_;          ///< sizes differ, or some are immobile: each pair is looked at
  ListRange list_range_;
  bool is_crowded_ = false;             ///< and the balls are still wide
  std::array<int, Dim> cell_grains_{};  ///< sides of a cell, rounded
  int slide_grains_ = 0;   ///< by which adjacent layers slide while half of a list's time passes
  Real offset_ = 0;        ///< of the upper image of the box at the start, diameters
  double odd_offset_ = 0;  ///< of it the part beside whole cells, in cells
  HugePageVector<Sphere> spheres_;
  HugePageVector<Vec<Dim, double>> boxes_;  ///< of each sphere: faces that it has come through
  std::optional<CellSearch<Dim>> search_;   ///< in place of lists and reference positions, or none
  NeighbourLists lists_;
  ReferenceCells reference_cells_;                       ///< of spheres of one size
  std::optional<SizedReferenceCells<Dim>> sized_cells_;  ///< in place of these, or none
  std::vector<Neighbour> nearby_;                        ///< scratch
  std::array<Image<Dim, Real>, 256> images_{};           ///< by their codes, at remainder 0
};

}  // namespace zenosphere
