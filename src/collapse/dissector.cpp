#include "collapse/dissector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collapse/decay.hpp"
#include "model/instantiate.hpp"
#include "model/real.hpp"

namespace zenosphere {

namespace {

/// Twice could be chance: a pair that parts slowly is sent together again by its neighbours.
constexpr std::int64_t fewest_repeats = 3;

template <int Dim, class Real>
Vec<Dim, double> in_double(const Vec<Dim, Real>& vector) {
  Vec<Dim, double> result;
  for (int axis = 0; axis < Dim; ++axis) result[axis] = static_cast<double>(vector[axis]);
  return result;
}

/// The pairs of a cluster, numbered, and each of its collisions in turn.
template <int Dim, class Real>
class ClusterSequence {
 public:
  using Trace = CollisionTrace<Dim, Real>;

  ClusterSequence(const Cluster& cluster, const Instant<Real>& moment, const Real& clock_unit)
      : moment_(moment), clock_unit_(clock_unit) {
    for (const auto& contact : cluster.contacts) {
      pairs_.emplace(std::pair(contact.i, contact.j), static_cast<int>(pairs_.size()));
    }
  }

  void observe(const Trace& trace) {
    const auto pair = pairs_.find({trace.i, trace.j});
    if (pair == pairs_.end()) return;
    ClusterStep<Real> step;
    step.pair = pair->second;
    step.time = elapsed(moment_, trace.time, clock_unit_);
    step.normal_speed = trace.normal_speed;
    step.flight = step.gap = std::numeric_limits<Real>::quiet_NaN();
    if (last_number_ > 0) {
      step.flight = elapsed(last_time_, trace.time, clock_unit_);
      // Where others have collided since, the gap is what the closing speed has covered.
      step.gap = trace.number == last_number_ + 1 ? trace.gap_before
                                                  : Real(step.normal_speed * step.flight);
    }
    last_number_ = trace.number;
    last_time_ = trace.time;
    steps_.push_back(step);
    add_row(trace, step);
  }

  const std::vector<ClusterStep<Real>>& steps() const { return steps_; }
  const ClusterCollisions& rows() const { return rows_; }

 private:
  void add_row(const Trace& trace, const ClusterStep<Real>& step) {
    rows_.k.push_back(trace.number);
    rows_.time.push_back(static_cast<double>(step.time));
    rows_.i.push_back(trace.i);
    rows_.j.push_back(trace.j);
    rows_.gap.push_back(nearest_double(step.gap));
    rows_.normal_speed.push_back(nearest_double(step.normal_speed));
    rows_.flight.push_back(static_cast<double>(step.flight));
  }

  Instant<Real> moment_;
  Real clock_unit_;
  std::map<std::pair<std::int32_t, std::int32_t>, int> pairs_;
  std::vector<ClusterStep<Real>> steps_;
  ClusterCollisions rows_;
  std::int64_t last_number_ = 0;
  Instant<Real> last_time_;
};

}  // namespace

template <int Dim, class Real>
void Dissector<Dim, Real>::observe(const Collision<Dim, Real>& collision) {
  const bool is_hit = !recent_.is_empty() && collision.gap_before <= threshold_;
  if (is_hit && !anatomy_.hit) {
    const Pair pair{collision.i, collision.j};
    const auto traces = recent_.traces();
    Contacts contacts = contacts_of(traces);
    contacts.normals[pair] = in_double(collision.impact.normal);
    add_last_collision(traces, pair, contacts);
    anatomy_.hit = dissection(traces, {pair}, contacts);
  }
  recent_.observe(collision);
}

template <int Dim, class Real>
void Dissector<Dim, Real>::observe_next(const Pair& pair, const Real& gap) {
  if (anatomy_.hit || gap > threshold_) return;
  const auto traces = recent_.traces();
  if (traces.empty()) return;
  Contacts contacts = contacts_of(traces);
  add_last_collision(traces, pair, contacts);
  anatomy_.hit = dissection(traces, {pair}, contacts);
}

template <int Dim, class Real>
void Dissector<Dim, Real>::observe_arrest(const std::vector<Pair>& pairs) {
  if (anatomy_.arrest) return;
  const auto traces = recent_.traces();
  Contacts contacts = contacts_of(traces);
  for (const Pair& pair : pairs) add(pair, contacts);
  anatomy_.arrest = dissection(traces, pairs, contacts);
}

/// The contacts that repeat, and the lines of centres of all.
template <int Dim, class Real>
typename Dissector<Dim, Real>::Contacts Dissector<Dim, Real>::contacts_of(
    const std::vector<Trace>& traces) const {
  const auto window = static_cast<std::size_t>(std::clamp(spheres_ / 4, 64, 1024));
  const std::size_t before = recent_.before_stretch();
  std::map<Pair, std::int64_t> counts;
  Contacts contacts;
  for (std::size_t n = before - std::min(before, window); n < traces.size(); ++n) {
    const Pair pair{traces[n].i, traces[n].j};
    ++counts[pair];
    contacts.normals[pair] = in_double(traces[n].normal);
  }
  for (const auto& [pair, count] : counts) {
    if (count < fewest_repeats) continue;
    add(pair, contacts);
    contacts.counts[pair] = count;
  }
  return contacts;
}

/// Makes two spheres neighbours, if the line of their centres is known.
template <int Dim, class Real>
void Dissector<Dim, Real>::add(const Pair& pair, Contacts& contacts) const {
  const auto [i, j] = pair;
  contacts.graph.add(i);
  if (j < spheres_) contacts.graph.add(j);
  if (!contacts.normals.contains(pair)) return;
  if (j < spheres_) contacts.graph.connect(i, j);
  contacts.counts.try_emplace(pair, 0);
}

/// The pair of a hit, and the collision that brought it about.
template <int Dim, class Real>
void Dissector<Dim, Real>::add_last_collision(const std::vector<Trace>& traces, const Pair& hit,
                                              Contacts& contacts) const {
  add(hit, contacts);
  const Pair last{traces.back().i, traces.back().j};
  const auto takes_part = [&](std::int32_t sphere) {
    return sphere < spheres_ && (sphere == last.first || sphere == last.second);
  };
  if (!takes_part(hit.first) && !takes_part(hit.second)) return;
  add(last, contacts);
  contacts.counts[last] = std::max<std::int64_t>(contacts.counts[last], 1);
}

template <int Dim, class Real>
Dissection Dissector<Dim, Real>::dissection(const std::vector<Trace>& traces,
                                            const std::vector<Pair>& pairs,
                                            const Contacts& contacts) const {
  Dissection result;
  result.collision = traces.back().number;
  result.time = since_start(traces.back().time, clock_unit_);
  result.pairs = pairs;
  for (const auto& [i, j] : pairs) add_cluster(i, contacts, result.clusters);
  const auto own = static_cast<std::ptrdiff_t>(result.clusters.size());
  for (const auto& [pair, count] : contacts.counts) {
    add_cluster(pair.first, contacts, result.clusters);
  }
  std::stable_sort(result.clusters.begin() + own, result.clusters.end(),
                   [](const Cluster& one, const Cluster& other) {
                     return one.spheres.size() > other.spheres.size();
                   });
  follow(traces, result);
  return result;
}

/// Adds the cluster of a sphere, if it is not there yet.
template <int Dim, class Real>
void Dissector<Dim, Real>::add_cluster(std::int32_t sphere, const Contacts& contacts,
                                       std::vector<Cluster>& clusters) const {
  const auto holds = [&](const Cluster& cluster) {
    return std::binary_search(cluster.spheres.begin(), cluster.spheres.end(), sphere);
  };
  if (std::any_of(clusters.begin(), clusters.end(), holds)) return;
  clusters.push_back(cluster(sphere, contacts));
}

template <int Dim, class Real>
Cluster Dissector<Dim, Real>::cluster(std::int32_t sphere, const Contacts& contacts) const {
  const auto spheres = contacts.graph.component(sphere);
  Cluster result = cluster_of<Dim>(spheres, contacts.graph, contacts.normals);
  for (const auto& [pair, count] : contacts.counts) {
    if (!std::binary_search(spheres.begin(), spheres.end(), pair.first)) continue;
    result.contacts.push_back({pair.first, pair.second, count});
  }
  return result;
}

/// Adds the collisions of the first cluster, and how they decay.
template <int Dim, class Real>
void Dissector<Dim, Real>::follow(const std::vector<Trace>& traces, Dissection& dissection) const {
  using std::abs;
  ClusterSequence<Dim, Real> sequence(dissection.clusters.front(), traces.back().time, clock_unit_);
  Real reading = clock_unit_;
  for (const Trace& trace : traces) {
    sequence.observe(trace);
    reading = std::max(reading, Real(abs(trace.time.remainder)));
  }
  dissection.collisions = sequence.rows();
  dissection.decay = decay_of(sequence.steps(), reading);
  auto& decay = dissection.decay;
  const auto balls = static_cast<int>(dissection.clusters.front().chain.size());
  if (restitution_) decay.exact = chain_factors(balls, *restitution_);
  if (decay.collapse_time_after) decay.collapse_time = dissection.time + *decay.collapse_time_after;
}

template <int Dim, class Real>
void Dissector<Dim, Real>::require_possible() const {
  for (const Trace& trace : recent_.traces()) {
    require_counts(trace.number);
    require_archived(is_pair({trace.i, trace.j}, spheres_), "a collision that there is not");
  }
  for (const auto& dissection : {anatomy_.hit, anatomy_.arrest}) {
    require_archived(!dissection || is_possible(*dissection, Dim, spheres_),
                     "a cluster that there is not");
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Dissector<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
