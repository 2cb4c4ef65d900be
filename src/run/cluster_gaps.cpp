#include "run/cluster_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "model/contact.hpp"
#include "model/instantiate.hpp"
#include "run/kept_collisions.hpp"

namespace zenosphere {
namespace {

/// The smallest of the gaps that count: one pair that recedes is passed over.
class SmallestGap {
 public:
  void add(double depth, bool recedes) {
    double& place = recedes ? receding_ : approaching_;
    if (recedes) second_receding_ = std::max(second_receding_, std::min(depth, receding_));
    place = std::max(place, depth);
  }
  double depth() const { return std::max(approaching_, second_receding_); }

 private:
  double approaching_ = 0;
  double receding_ = 0;
  double second_receding_ = 0;
};

}  // namespace

template <int Dim, class Real>
ClusterGaps<Dim, Real>::ClusterGaps(const Simulation<Dim, Real>& simulation)
    : box_(simulation.box()), state_(simulation.configuration()) {
  if constexpr (Dim > 1) offset_ = simulation.lees_edwards_offset();
}

template <int Dim, class Real>
typename ClusterGaps<Dim, Real>::Relative ClusterGaps<Dim, Real>::relative(std::int32_t i,
                                                                           std::int32_t j) const {
  using std::floor;
  const auto a = static_cast<std::size_t>(i);
  const auto b = static_cast<std::size_t>(j);
  Relative way{state_.positions[b], state_.velocities[b]};
  way.dr -= state_.positions[a];
  way.dv -= state_.velocities[a];
  for (int axis = Dim - 1; axis >= 0; --axis) {  // y first: it moves x
    if (box_.is_closed(axis)) continue;
    const Real& side = box_.sides()[axis];
    const Real periods = floor(Real(way.dr[axis] / side + Real(0.5)));
    way.dr[axis] -= periods * side;
    if (axis == 1) way.dr[0] -= periods * offset_;
  }
  if constexpr (Dim > 1) way.dv[0] += box_.shear_rate() * way.dr[1];
  return way;
}

template <int Dim, class Real>
double ClusterGaps<Dim, Real>::smallest(std::span<const std::int32_t> spheres, double limit) const {
  SmallestGap smallest;
  const auto add = [&](const Real& gap, const Real& rate) {
    smallest.add(std::clamp(decades_of(gap, limit), 0.0, limit), rate > 0);
  };
  for (auto i = spheres.begin(); i != spheres.end(); ++i) {
    for (auto j = i + 1; j != spheres.end(); ++j) {
      const Relative way = relative(*i, *j);
      const Real sigma = state_.grains.radius(*i) + state_.grains.radius(*j);
      add(gap(way.dr, sigma), dot(way.dr, way.dv));
    }
    const auto axis = box_.closed_axis();
    if (!axis) continue;
    const auto own = static_cast<std::size_t>(*i);
    const Real& place = state_.positions[own][*axis];
    const Real& speed = state_.velocities[own][*axis];
    const Real radius = state_.grains.radius(*i);
    add(Real(place - radius), speed);
    add(Real(box_.sides()[*axis] - radius - place), Real(-speed));
  }
  return smallest.depth();
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class ClusterGaps<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
