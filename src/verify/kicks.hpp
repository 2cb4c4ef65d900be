#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "case/case.hpp"
#include "model/grains.hpp"
#include "model/random.hpp"
#include "model/vec.hpp"

namespace zenosphere::verify {

/// The kicks of a randomly driven run, made again from its seed: no file holds them.
template <int Dim>
class Kicks {
 public:
  Kicks(const Case& values, std::int64_t spheres, const Grains<double>& grains = {});

  /// Time of the next kick; infinity where there are none.
  double next() const { return next_; }

  /// The largest change of a velocity by the next kick, diameters/time.
  long double largest() const { return largest_; }

  /// Velocity changes of the next kick, one for each sphere, diameters/time.
  std::vector<Vec<Dim, long double>> take();

 private:
  void draw();
  void take_off_mean();

  Grains<double> grains_;
  Random random_;
  std::size_t spheres_;
  double interval_;
  double step_;  ///< standard deviation of each component, diameters/time
  bool keeps_momentum_;
  std::int64_t taken_ = 0;
  double next_ = std::numeric_limits<double>::infinity();
  std::vector<Vec<Dim, long double>> changes_;  ///< of the next kick
  long double largest_ = 0;                     ///< of them
};

}  // namespace zenosphere::verify
