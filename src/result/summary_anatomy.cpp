#include "result/summary.hpp"

namespace zenosphere {

namespace {

std::optional<double> ratio_of(const std::optional<DecayRate>& rate) {
  return rate ? std::optional(rate->ratio) : std::nullopt;
}

std::optional<Summary::Dissected> in_short(const std::optional<Dissection>& dissection) {
  if (!dissection) return std::nullopt;
  const Cluster& first = dissection->clusters.front();
  const Decay& decay = dissection->decay;
  Summary::Dissected result;
  result.collision = dissection->collision;
  result.time = dissection->time;
  result.clusters = static_cast<std::int64_t>(dissection->clusters.size());
  result.spheres = static_cast<std::int64_t>(first.spheres.size());
  result.contacts = static_cast<std::int64_t>(first.contacts.size());
  result.chain.assign(first.chain.begin(), first.chain.end());
  result.straightness = first.straightness;
  result.cycle = decay.cycle;
  result.gap_ratio = ratio_of(decay.gap);
  result.speed_ratio = ratio_of(decay.speed);
  result.flight_ratio = ratio_of(decay.flight);
  if (const auto& exact = decay.exact) {
    result.exact_gap_ratio = exact->gap;
    result.exact_speed_ratio = exact->speed;
    result.exact_flight_ratio = exact->flight;
  }
  result.collapse_time = decay.collapse_time;
  if (decay.collapse_time) result.collapse_time_error = decay.error_since_start();
  return result;
}

}  // namespace

Summary::Anatomy in_short(const Anatomy& anatomy) {
  return {in_short(anatomy.hit), in_short(anatomy.arrest)};
}

}  // namespace zenosphere
