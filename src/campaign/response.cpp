#include "campaign/response.hpp"

#include <algorithm>
#include <cmath>

#include "model/elementary.hpp"

namespace zenosphere {
namespace {

/// Nodes of c in a resolution: the interval's ends are interpolated between them.
constexpr double nodes_a_resolution = 6;
/// Nodes of c at least, for a coarse resolution.
constexpr double fewest_nodes = 120;
/// Values of s; neighbours differ by less than a factor of two down to 1/4000 of the range.
constexpr int scales = 16;
/// What has less than this share of the largest weight is dropped: it would need 30 runs against
/// all others to matter.
constexpr double impossible = 1e-9;

struct Odds {
  double rising, falling;  ///< P and 1 - P, each without cancellation
};

Odds odds(double x, double c, double s) {
  const double z = (x - c) / s;
  const double t = portable_exp(-std::abs(z));
  const double large = 1 / (1 + t), small = t / (1 + t);
  return z > 0 ? Odds{large, small} : Odds{small, large};
}

}  // namespace

Response::Response(double from, double to, double resolution) : from_(from), to_(to) {
  const double length = to - from;
  const double wanted = std::ceil(3 * length / resolution * nodes_a_resolution);
  const double count = std::max(wanted, fewest_nodes);
  step_ = 3 * length / count;
  const double least = resolution / 10;
  const double ratio = std::sqrt(std::sqrt(std::sqrt(std::sqrt(length / least))));
  for (double k = 0; k < count; ++k) {
    double s = least;
    for (int scale = 0; scale <= scales; ++scale, s *= ratio) {
      nodes_.push_back({from - length + (k + 0.5) * step_, s, 1, 1});
    }
  }
}

void Response::observe(double x, bool is_met) {
  for (Node& node : nodes_) {
    const Odds p = odds(x, node.c, node.s);
    node.rising *= is_met ? p.rising : p.falling;
    node.falling *= is_met ? p.falling : p.rising;
  }
  forget_the_impossible();
}

void Response::forget_the_impossible() {
  double most = 0;
  for (const Node& node : nodes_) most = std::max({most, node.rising, node.falling});
  for (Node& node : nodes_) {
    node.rising = node.rising < impossible * most ? 0 : node.rising / most;
    node.falling = node.falling < impossible * most ? 0 : node.falling / most;
  }
  std::erase_if(nodes_, [](const Node& node) { return node.rising + node.falling == 0; });
  if (nodes_.size() < nodes_.capacity() / 2) nodes_.shrink_to_fit();
}

double Response::total() const {
  double sum = 0;
  for (const Node& node : nodes_) sum += node.rising + node.falling;
  return sum;
}

double Response::rising() const {
  double sum = 0;
  for (const Node& node : nodes_) sum += node.rising;
  return sum / total();
}

double Response::outside(Direction direction, int side) const {
  double sum = 0;
  for (const Node& node : nodes_) {
    const bool is_there = side > 0 ? node.c > to_ : node.c < from_;
    if (is_there) sum += weight_of(node, direction);
  }
  return sum / total();
}

double Response::quantile(double probability) const {
  double missing = probability * total();
  for (auto node = nodes_.begin(); node != nodes_.end();) {
    const double c = node->c;
    double here = 0;
    for (; node != nodes_.end() && node->c == c; ++node) here += node->rising + node->falling;
    if (missing <= here) return c + (missing / here - 0.5) * step_;
    missing -= here;
  }
  return nodes_.back().c + 0.5 * step_;
}

double Response::mean(double x, Direction direction) const {
  double sum = 0, weights = 0;
  for (const Node& node : nodes_) {
    const double weight = weight_of(node, direction);
    if (weight == 0) continue;
    const Odds p = odds(x, node.c, node.s);
    sum += weight * (direction == Direction::rising ? p.rising : p.falling);
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0.5;
}

}  // namespace zenosphere
