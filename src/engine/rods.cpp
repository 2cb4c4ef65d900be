#include "engine/rods.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace zenosphere {

std::vector<Vec<1, double>> rod_places(std::span<const double> lengths,
                                       const ShearBox<1, double>& box, Random& random) {
  const double room = box.sides()[0] - std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!(room > 0)) throw std::invalid_argument("the rods fill the box");
  std::vector<double> points(lengths.size());
  for (double& point : points) point = room * random.uniform();
  std::sort(points.begin(), points.end());
  std::vector<Vec<1, double>> places;
  double filled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    places.push_back({points[i] + filled + lengths[i] / 2});
    filled += lengths[i];
  }
  return places;
}

}  // namespace zenosphere
