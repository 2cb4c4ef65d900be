#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "model/grains.hpp"
#include "result/summary.hpp"
#include "storage/records.hpp"
#include "verify/findings.hpp"

namespace zenosphere::verify {

/// Looks at each snapshot by itself and beside the one before: what must hold without following the
/// motion, however long the time between them.
class SnapshotCheck {
 public:
  using Number = long double;  ///< squares of speeds of any double are numbers of it

  /// \param last_time  that of the file: nothing happens later
  /// \param grains     likewise
  SnapshotCheck(const Case& values, double last_time, const Grains<double>& grains = {});

  /// \param lost  energy, in the collisions since the snapshot before, if the log tells
  /// \return      whether a replay can begin here
  bool observe(const Snapshot& snapshot, std::optional<Number> lost, Findings& findings);

  /// Compares the last snapshot with the summary, and the energy of the whole run with its
  /// averages.
  void compare(const Summary& summary, Findings& findings) const;

  /// Whether energy has been balanced between snapshots, or over the whole run.
  std::int64_t balances() const { return balances_; }

 private:
  struct Sums {
    std::int64_t step = 0;
    double time = 0;
    Number kinetic = 0;                  ///< of the peculiar velocities and the spins
    Number potential = 0;                ///< of gravity
    std::vector<Number> momentum{};      ///< peculiar, D
    Number speeds = 0;                   ///< sum of m |v| over all components
    std::optional<Number> lost{};        ///< since the snapshot before
    std::optional<Number> dissipated{};  ///< since the start, likewise
  };

  bool check_numbers(const Snapshot& snapshot, Findings& findings) const;
  void check_box(const Snapshot& snapshot, Findings& findings) const;
  void check_overlaps(const Snapshot& snapshot, Findings& findings) const;
  void check_momentum(const Sums& sums, Findings& findings) const;
  void check_energy(const Sums& sums, Findings& findings);
  bool energy_is_closed() const;
  Number mobile_mass(std::size_t i) const;
  Number turning_energy(const Snapshot& snapshot) const;
  Sums sums_of(const Snapshot& snapshot, std::optional<Number> lost) const;

  const Case& values_;
  double last_time_;
  Grains<double> grains_;
  Number mass_ = 0;  ///< of all mobile spheres
  std::vector<double> sides_;
  std::vector<double> acceleration_;
  std::optional<int> closed_;
  double start_offset_ = 0;  ///< of the images, where a file tells it, diameters
  std::optional<Sums> first_;
  std::optional<Sums> last_;
  std::int64_t balances_ = 0;
};

}  // namespace zenosphere::verify
