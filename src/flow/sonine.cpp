#include "flow/sonine.hpp"

#include <vector>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
double second_sonine_coefficient(std::span<const Vec<Dim, double>> velocities) {
  const auto number = static_cast<double>(velocities.size());
  Vec<Dim, double> mean;
  for (const auto& velocity : velocities) mean += velocity * (1 / number);
  std::vector<double> squares;
  squares.reserve(velocities.size());
  double mean_square = 0;
  for (const auto& velocity : velocities) {
    squares.push_back(dot(velocity - mean, velocity - mean));
    mean_square += squares.back() / number;
  }
  if (!(mean_square > 0)) return 0;
  double fourth = 0;
  for (const double square : squares) {
    fourth += (square / mean_square) * (square / mean_square) / number;
  }
  const double free = (number - 1) * Dim;  // components that are independent of each other
  return Dim / (Dim + 2.0) * fourth * (free + 2) / free - 1;
}

#define ZENOSPHERE_INSTANTIATE(Dim) \
  template double second_sonine_coefficient<Dim>(std::span<const Vec<Dim, double>>);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
