#include "flow/observable_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

Observables observables(double temperature, double rate, double speed) {
  Observables result;
  result.granular_temperature = temperature;
  result.temperature_diagonal = {temperature};
  result.pressure_tensor = {2 * temperature};
  result.collision_rate = rate;
  result.normal_speed = speed;
  result.compressibility_factor = 3;
  return result;
}

ObservableSeries series_of_ten_spheres() { return {observables(0, 0, 0), 0.5, 10}; }

const ObservableColumn& column(const ObservableSeries& series, const std::string& name) {
  for (const ObservableColumn& column : series.columns()) {
    if (column.name == name) return column;
  }
  throw std::out_of_range(name);
}

TEST(ObservableSeries, GivesBackWhatWasAdded) {
  auto series = series_of_ten_spheres();
  series.add(observables(1, 2, 5), 100);
  series.add(observables(4, 0, std::nan("")), 100);  // no collision: no speed of collisions
  EXPECT_EQ(series.rows(), 2u);
  EXPECT_EQ(series.end(), 1);
  EXPECT_EQ(series.values(column(series, "granular_temperature")), (std::vector<double>{1, 4}));
  EXPECT_EQ(series.values(column(series, "pressure_tensor")), (std::vector<double>{2, 8}));
  const auto speeds = series.values(column(series, "normal_speed"));
  EXPECT_EQ(speeds[0], 5);
  EXPECT_TRUE(std::isnan(speeds[1]));
}

// Rates 2 and 6: three collisions of four have the speed 1, so 0.25 x 5 + 0.75 x 1 = 2.
TEST(ObservableSeries, WeighsWhatIsPerCollisionWithTheCollisions) {
  auto series = series_of_ten_spheres();
  series.add(observables(1, 2, 5), 100);
  series.add(observables(4, 6, 1), 200);
  const Observables mean = series.mean(0, {}, 0);
  EXPECT_DOUBLE_EQ(mean.normal_speed, 2);
  EXPECT_DOUBLE_EQ(mean.granular_temperature, 2.5);
  EXPECT_DOUBLE_EQ(mean.compressibility_factor, 3);
  const Observables with_the_rest = series.mean(1, observables(1, 6, 3), 0.5);
  EXPECT_DOUBLE_EQ(with_the_rest.granular_temperature, 2.5);
  EXPECT_DOUBLE_EQ(with_the_rest.normal_speed, 2);
}

// Pressures 1 and 3: the stress differences 0.5 x 1 and 0.1 x 3 over the mean pressure 2 of both.
TEST(ObservableSeries, WeighsNormalStressDifferencesWithThePressure) {
  Observables first, second;
  first.pressure = 1;
  first.normal_stress_differences = {0.5, 0};
  second.pressure = 3;
  second.normal_stress_differences = {0.1, 0};
  ObservableSeries series(first, 0.5, 10);
  series.add(first, 100);
  series.add(second, 200);
  EXPECT_DOUBLE_EQ(series.mean(0, {}, 0).normal_stress_differences[0], (0.5 + 0.3) / 2 / 2);
  const auto values = series.values(column(series, "normal_stress_differences"));
  ASSERT_EQ(values.size(), 4u);
  EXPECT_DOUBLE_EQ(values[0], 0.5);
  EXPECT_DOUBLE_EQ(values[2], 0.1);
}

TEST(ObservableSeries, LinearisesAboutTheAverage) {
  auto series = series_of_ten_spheres();
  series.add(observables(1, 2, 5), 100);
  series.add(observables(4, 6, 1), 200);
  const auto speeds = series.linearised(column(series, "normal_speed").first, 0);
  EXPECT_DOUBLE_EQ((speeds[0] + speeds[1]) / 2, 2);
  EXPECT_DOUBLE_EQ(speeds[0], 2 + (2 * 5 - 2 * 2) / 4.0);
}

TEST(ObservableSeries, DoublesItsIntervalAndLosesNoAverage) {
  auto series = series_of_ten_spheres();
  const auto many = static_cast<std::int64_t>(ObservableSeries::most_rows);
  double sum = 0;
  for (std::int64_t k = 1; k <= many; ++k) {
    series.add(observables(static_cast<double>(k), 2, 5), 1000 * k);
    sum += static_cast<double>(k);
  }
  EXPECT_EQ(series.rows(), ObservableSeries::most_rows / 2);
  EXPECT_EQ(series.interval(), 1);
  EXPECT_EQ(series.end(), 0.5 * static_cast<double>(many));
  EXPECT_EQ(series.steps().front(), 2000);
  EXPECT_DOUBLE_EQ(series.mean(0, {}, 0).granular_temperature, sum / static_cast<double>(many));
}

// 10 spheres have two collisions each in ten collisions of two.
TEST(ObservableSeries, HasAtMostOneRowForTwoCollisionsOfASphere) {
  auto series = series_of_ten_spheres();
  for (int k = 0; k < 500; ++k) series.add(observables(1, 0, 0), 1000);
  EXPECT_LE(series.rows(), 100u);
  EXPECT_GE(series.end(), 100);
}

TEST(ObservableSeries, ComesBackFromAnArchive) {
  auto series = series_of_ten_spheres();
  series.add(observables(1, 2, 5), 100);
  ArchiveWriter writer;
  writer(series);
  auto copy = series_of_ten_spheres();
  ArchiveReader reader(writer.bytes());
  reader(copy);
  EXPECT_EQ(copy.steps(), series.steps());
  EXPECT_EQ(copy.mean(0, {}, 0).normal_speed, 5);
  ObservableSeries other({}, 0.5, 10);
  ArchiveReader again(writer.bytes());
  EXPECT_THROW(again(other), ArchiveError);
}

}  // namespace
}  // namespace zenosphere
