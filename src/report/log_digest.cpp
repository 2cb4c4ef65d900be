#include "report/log_digest.hpp"

#include <algorithm>
#include <cmath>

namespace zenosphere {

LogDigest::LogDigest(std::int64_t rows, std::int64_t width) {
  stretch_.width = width;
  const auto bins = static_cast<std::size_t>((rows + width - 1) / width);
  for (auto* column :
       {&stretch_.k, &stretch_.time, &stretch_.gap_low, &stretch_.gap_high, &stretch_.speed_low,
        &stretch_.speed_high, &stretch_.flight_low, &stretch_.flight_high}) {
    column->reserve(bins);
  }
}

void LogDigest::begin_bin(const CollisionRow& row) {
  stretch_.k.push_back(static_cast<double>(row.k));
  stretch_.time.push_back(row.time);
  stretch_.gap_low.push_back(row.gap);
  stretch_.gap_high.push_back(row.gap);
  stretch_.speed_low.push_back(row.normal_speed);
  stretch_.speed_high.push_back(row.normal_speed);
  stretch_.flight_low.push_back(std::numeric_limits<double>::quiet_NaN());
  stretch_.flight_high.push_back(std::numeric_limits<double>::quiet_NaN());
  stretch_.hits.push_back(0);
  stretch_.flags.push_back(0);
  if (stretch_.width > 1) return;
  stretch_.i.push_back(row.i);
  stretch_.j.push_back(row.j);
}

void LogDigest::observe(const CollisionRow& row) {
  if (in_bin_ == 0) begin_bin(row);
  in_bin_ = (in_bin_ + 1) % stretch_.width;
  const double flight = before_ && row.k == before_->k + 1
                            ? row.time - before_->time
                            : std::numeric_limits<double>::quiet_NaN();
  before_ = row;
  // fmin and fmax pass over a NaN, which is an unknown gap or flight.
  stretch_.last = row.k;
  stretch_.time.back() = row.time;
  stretch_.gap_low.back() = std::fmin(stretch_.gap_low.back(), row.gap);
  stretch_.gap_high.back() = std::fmax(stretch_.gap_high.back(), row.gap);
  stretch_.speed_low.back() = std::fmin(stretch_.speed_low.back(), row.normal_speed);
  stretch_.speed_high.back() = std::fmax(stretch_.speed_high.back(), row.normal_speed);
  stretch_.flight_low.back() = std::fmin(stretch_.flight_low.back(), flight);
  stretch_.flight_high.back() = std::fmax(stretch_.flight_high.back(), flight);
  stretch_.hits.back() += (row.flags & collision_flag::hit) != 0 ? 1 : 0;
  stretch_.flags.back() |= row.flags;
}

}  // namespace zenosphere
