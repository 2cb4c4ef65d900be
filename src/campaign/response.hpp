#pragma once

#include <cstdint>
#include <vector>

namespace zenosphere {

/// What is known of a probability that rises or falls along an axis, after some runs.
///
/// The probability is P(x) = 1 / (1 + exp(-+(x - c) / s)). Before any run, rising and falling are
/// equally likely, c is uniform from one length of the range below it to one above it, and s is
/// uniform in logarithm from a tenth of the resolution to the length of the range. The posterior
/// is kept on a grid of c and s, whose nodes of c are a sixth of the resolution apart; it is
/// exact up to that, needs no search for a maximum, and exists for separated counts as well.
///
/// The same runs give the same bits on every machine.
///
/// Source: Bayesian logistic response on a grid: A. B. Watson & D. G. Pelli, Percept. Psychophys.
/// 33 (1983) 113; with the slope: L. L. Kontsevich & C. W. Tyler, Vision Res. 39 (1999) 2729.
class Response {
 public:
  /// \param from, to    the range of x, from < to
  /// \param resolution  length in x that matters, from a thousandth of to - from to all of it; at a
  ///                    thousandth the grid takes 10 MB, and a run 5 ms while all is possible
  Response(double from, double to, double resolution);

  /// Learns from one run at x.
  void observe(double x, bool is_met);

  /// Probability that P rises with x.
  double rising() const;

  /// Probability that P is below (above) 1/2 in the whole range.
  double below() const { return outside(Direction::rising, 1) + outside(Direction::falling, -1); }
  double above() const { return outside(Direction::rising, -1) + outside(Direction::falling, 1); }

  /// The x below which c lies with a probability; outside the range where c may be there.
  double quantile(double probability) const;

  enum class Direction { rising, falling };

  /// Mean of P(x) over what is possible, if it goes in this direction.
  double mean(double x, Direction direction) const;

 private:
  struct Node {
    double c;
    double s;
    double rising, falling;  ///< weights
  };

  double weight_of(const Node& node, Direction direction) const {
    return direction == Direction::rising ? node.rising : node.falling;
  }
  double total() const;
  double outside(Direction direction, int side) const;
  void forget_the_impossible();

  double from_, to_, step_;
  std::vector<Node> nodes_;  ///< c ascending
};

}  // namespace zenosphere
