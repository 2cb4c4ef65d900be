#include "run/observed_simulation.hpp"

#include "run/arithmetic.hpp"
#include "run/observed.hpp"
#include "run/setup.hpp"
#include "run/state_head.hpp"

namespace zenosphere {

std::unique_ptr<ObservedSimulation> new_observed(const Case& values,
                                                 const std::atomic<bool>* interrupt) {
  using Result = std::unique_ptr<ObservedSimulation>;
  return in_arithmetic_of(values, [&]<int Dim, class Real>() -> Result {
    return std::make_unique<Observed<Dim, Real>>(values, interrupt,
                                                 new_simulation<Dim, Real>(values));
  });
}

std::unique_ptr<ObservedSimulation> archived_observed(const Case& values,
                                                      const std::atomic<bool>* interrupt,
                                                      const RecoveredOutput& output,
                                                      ArchiveReader& state) {
  using Result = std::unique_ptr<ObservedSimulation>;
  return in_arithmetic_of(values, [&]<int Dim, class Real>() -> Result {
    require_known_state<Dim, Real>(values, output, state);
    return std::make_unique<Observed<Dim, Real>>(values, interrupt, state);
  });
}

}  // namespace zenosphere
