#include "proof/enclose_cluster.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "model/repeated_round.hpp"
#include "proof/ball_spheres.hpp"
#include "proof/letters.hpp"

namespace zenosphere {

namespace {

using Kind = Certificate::Kind;
using Pair = BallSpheres::Pair;

/// The neighbours of each sphere in the pairs of a round.
std::map<int, std::vector<int>> graph_of(const std::vector<Pair>& pairs) {
  std::map<int, std::vector<int>> graph;
  for (const auto& [i, j] : pairs) {
    graph[i].push_back(j);
    graph[j].push_back(i);
  }
  return graph;
}

/// The spheres from one end of a chain to the other; or, where they are no chain, by their number.
std::vector<int> in_order(const std::map<int, std::vector<int>>& graph) {
  std::vector<int> spheres;
  for (const auto& [sphere, neighbours] : graph) spheres.push_back(sphere);
  const auto end = std::find_if(graph.begin(), graph.end(),
                                [](const auto& node) { return node.second.size() == 1; });
  if (end == graph.end()) return spheres;
  std::vector<int> chain{end->first};
  for (int next = end->second.front(); chain.size() < graph.size();) {
    const int before = chain.back();
    chain.push_back(next);
    const std::vector<int>& beside = graph.at(next);
    if (beside.size() == 1) break;
    if (beside.size() > 2) return spheres;  // a branch
    next = beside[0] == before ? beside[1] : beside[0];
  }
  return chain.size() == graph.size() ? chain : spheres;
}

/// The history of a cluster's collisions, as letters of its pairs.
class PairHistory {
 public:
  void add(const Pair& pair) {
    const auto [known, is_new] = letters_.try_emplace(pair, static_cast<int>(pairs_.size()));
    if (is_new) pairs_.push_back(pair);
    history_.push_back(known->second);
  }

  /// The round with which it ends, its letters in the order of its chain.
  void tell(Certificate& certificate) const {
    const auto word = round_at_end(history_);
    if (!word) return;
    std::vector<int> used = *word;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<Pair> met;
    for (const int letter : used) met.push_back(pairs_[letter]);
    certificate.spheres = in_order(graph_of(met));
    std::vector<Pair> ordered = in_chain(met, certificate.spheres);
    std::vector<int> renamed;
    for (const int letter : *word) {
      const auto place = std::find(ordered.begin(), ordered.end(), pairs_[letter]);
      renamed.push_back(static_cast<int>(place - ordered.begin()));
    }
    certificate.word = text_of_letters(first_rotation(renamed));
  }

 private:
  /// Sorted by the places of their spheres.
  static std::vector<Pair> in_chain(std::vector<Pair> pairs, const std::vector<int>& spheres) {
    const auto place = [&spheres](int sphere) {
      return std::find(spheres.begin(), spheres.end(), sphere) - spheres.begin();
    };
    std::sort(pairs.begin(), pairs.end(), [&place](const Pair& a, const Pair& b) {
      return std::minmax(place(a.first), place(a.second)) <
             std::minmax(place(b.first), place(b.second));
    });
    return pairs;
  }

  std::map<Pair, int> letters_;
  std::vector<Pair> pairs_;
  std::vector<int> history_;
};

bool has_to_stop(const ClusterLimits& limits) {
  return (limits.interrupt && *limits.interrupt) ||
         std::chrono::steady_clock::now() > limits.deadline;
}

/// One pass with so many bits.
struct Pass {
  Certificate certificate{};
  bool needs_bits = false;
};

class Enclosing {
 public:
  Enclosing(std::span<const ExactSphere> spheres, const PairRestitutions& restitutions,
            const ClusterLimits& limits)
      : spheres_(spheres, restitutions), limits_(limits) {}

  Pass pass() {
    Pass result;
    Certificate& certificate = result.certificate;
    while (true) {
      if (certificate.decades >= limits_.decades) {
        certificate.kind = Kind::enclosed;
        break;
      }
      if (is_over(certificate)) break;
      const BallSpheres::Event event = spheres_.next_event();
      result.needs_bits = event == BallSpheres::Event::not_certain;
      if (event == BallSpheres::Event::none_left) certificate.kind = Kind::escapes;
      if (event != BallSpheres::Event::collision) break;
      observe(certificate);
    }
    conclude(certificate);
    return result;
  }

 private:
  bool is_over(const Certificate& certificate) const {
    return certificate.collisions >= limits_.collisions || has_to_stop(limits_);
  }

  void observe(Certificate& certificate) {
    ++certificate.collisions;
    history_.add(spheres_.pair());
    const Ball& gap = spheres_.gap_before();
    // The gap of the first collision begins at the moment given, not at a collision.
    if (certificate.collisions == 1 || !gap.is_positive()) return;
    certificate.decades = std::max(certificate.decades, -decimal_exponent(gap.ends().upper) - 1);
  }

  void conclude(Certificate& certificate) const {
    history_.tell(certificate);
    if (certificate.collisions == 0) return;
    const Enclosure now = spheres_.now().ends();
    const Rational width = now.upper - now.lower;
    const int places = width > 0 ? places_for(width) : 20;
    certificate.lower = decimal_below(now.lower, places);
    certificate.upper = decimal_above(now.upper, places);
  }

  BallSpheres spheres_;
  ClusterLimits limits_;
  PairHistory history_;
};

/// Two spheres that overlap and approach have no next contact; nothing if there are no such two.
std::optional<Pair> overlapping(std::span<const ExactSphere> spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      Rational square = 0;
      Rational approach = 0;
      for (std::size_t k = 0; k < spheres[i].position.size(); ++k) {
        const Rational dr = spheres[j].position[k] - spheres[i].position[k];
        square += dr * dr;
        approach += dr * (spheres[j].velocity[k] - spheres[i].velocity[k]);
      }
      const Rational sigma = spheres[i].radius + spheres[j].radius;
      if (square < sigma * sigma && approach <= 0)
        return Pair(static_cast<int>(i), static_cast<int>(j));
    }
  }
  return std::nullopt;
}

std::string reason_of(const Pass& pass, long bits) {
  const Certificate& found = pass.certificate;
  const std::string followed =
      std::to_string(found.collisions) + " collisions with " + std::to_string(bits) + " bits";
  if (found.kind == Kind::enclosed) {
    return "the order of " + followed + " is certain, down to a gap below 1e-" +
           std::to_string(found.decades);
  }
  if (found.kind == Kind::escapes) return "no two spheres collide any more, after " + followed;
  if (pass.needs_bits) {
    return "the order of contacts is not certain after " + followed +
           ": two fall on one instant, or more bits are needed";
  }
  return "the gaps have not fallen as far as asked within " + followed;
}

}  // namespace

Certificate enclose_cluster(std::span<const ExactSphere> spheres,
                            const PairRestitutions& restitutions, const ClusterLimits& limits) {
  if (const auto pair = overlapping(spheres)) {
    return {.reason = "spheres " + std::to_string(pair->first) + " and " +
                      std::to_string(pair->second) + " overlap at the moment given"};
  }
  for (long bits = 512;; bits *= 2) {
    const BallPrecision precision(bits);
    Pass pass = Enclosing(spheres, restitutions, limits).pass();
    const bool is_last = 2 * bits > limits.bits || has_to_stop(limits);
    if (pass.needs_bits && !is_last) continue;
    pass.certificate.reason = reason_of(pass, bits);
    return pass.certificate;
  }
}

Certificate enclose_cluster(std::span<const ExactSphere> spheres, const Rational& restitution,
                            const ClusterLimits& limits) {
  return enclose_cluster(spheres, PairRestitutions(spheres.size(), restitution), limits);
}

}  // namespace zenosphere
