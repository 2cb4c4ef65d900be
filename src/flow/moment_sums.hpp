#pragma once

#include <tuple>
#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// Several observables that are summed up of the same moments; their columns follow one another.
///
/// Each is a class with a constructor from a SampledSystem, `columns()`, `edges()` and
/// `add(moment, sums)`, as PairSums has them.
template <int Dim, template <int> class... Parts>
class MomentSums {
 public:
  explicit MomentSums(const SampledSystem<Dim>& system) : parts_(Parts<Dim>(system)...) {}

  std::vector<SampledColumn> columns() const {
    return gathered<SampledColumn>([](const auto& part) { return part.columns(); });
  }
  std::vector<SampledEdges> edges() const {
    return gathered<SampledEdges>([](const auto& part) { return part.edges(); });
  }

  /// Adds a sample to the sums of `columns()`.
  void add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
    std::apply([&](const auto&... part) { (part.add(moment, sums), ...); }, parts_);
  }

  template <template <int> class Part>
  const Part<Dim>& of() const {
    return std::get<Part<Dim>>(parts_);
  }

 private:
  template <class Item, class List>
  std::vector<Item> gathered(const List& list) const {
    std::vector<Item> all;
    const auto append = [&](const std::vector<Item>& items) {
      all.insert(all.end(), items.begin(), items.end());
    };
    std::apply([&](const auto&... part) { (append(list(part)), ...); }, parts_);
    return all;
  }

  std::tuple<Parts<Dim>...> parts_;
};

}  // namespace zenosphere
