#include "collapse/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace zenosphere {
namespace {

/// The least but for one in a hundred.
double low_of(std::span<const double> margins) {
  std::vector<double> sorted(margins.begin(), margins.end());
  const auto low = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 100);
  std::nth_element(sorted.begin(), low, sorted.end());
  return *low;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::optional<double> gives_way_at(const Curvature& curvature) {
  if (curvature.per_decade >= 0) return std::nullopt;
  return curvature.depth + std::max(curvature.margin, 0.0) / -curvature.per_decade;
}

std::optional<Curvature> curvature_of(std::span<const double> depths,
                                      std::span<const double> margins) {
  if (depths.size() < 16) return std::nullopt;
  const std::size_t parts = std::clamp<std::size_t>(depths.size() / 16, 4, 16);
  const std::size_t size = depths.size() / parts;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < parts; ++k) {
    x.push_back(depths[k * size + size / 2]);
    y.push_back(low_of(margins.subspan(k * size, size)));
    if (!std::isfinite(y.back())) return std::nullopt;
  }
  const double mean_x = mean(x), mean_y = mean(y);
  double product = 0, square = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    product += (x[k] - mean_x) * (y[k] - mean_y);
    square += (x[k] - mean_x) * (x[k] - mean_x);
  }
  if (square == 0) return std::nullopt;
  const double slope = product / square;
  const double end = depths.back();
  return Curvature{mean_y + slope * (end - mean_x), slope, end};
}

}  // namespace zenosphere
