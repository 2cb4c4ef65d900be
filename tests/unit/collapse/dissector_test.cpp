#include "collapse/dissector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "collapse/recent_collisions.hpp"

namespace zenosphere {
namespace {

using Spheres = std::vector<std::int32_t>;
constexpr double dissected_gap = 1e-16;

/// Hands collisions to a dissector of 100 disks.
class Dissecting : public testing::Test {
 protected:
  using Normal = Vec<2, double>;

  void collide(std::int32_t i, std::int32_t j, double gap, double speed, double time,
               Normal normal = {{1, 0}}) {
    Collision<2, double> collision;
    collision.number = ++number;
    collision.i = i;
    collision.j = j;
    collision.gap_before = gap;
    collision.impact.normal = normal;
    collision.impact.normal_speed = speed;
    collision.time.remainder = time;
    dissector.observe(collision);
  }

  /// Three balls by the factors of e = 0.05, from sphere `first` on, until a gap of zero.
  void collapse(std::int32_t first, int collisions) {
    double gap = 1;
    double speed = 1;
    double time = 0;
    for (int n = 0; n < collisions; ++n) {
      time += gap / speed;
      const std::int32_t i = first + n % 2;
      collide(i, i + 1, gap, speed, time);
      gap *= 0.125;
      speed *= 0.4;
    }
  }

  Dissector<2, double> dissector{dissected_gap, 100, 1.0, 0.05};
  std::int64_t number = 0;
};

TEST_F(Dissecting, FindsTheClusterOfAHitAndItsFactors) {
  collapse(5, 16);
  EXPECT_FALSE(dissector.anatomy().hit);
  collide(5, 6, 0, 1e-6, 2);
  const Dissection hit = dissector.anatomy().hit.value();
  EXPECT_EQ(hit.collision, 16);
  ASSERT_EQ(hit.clusters.size(), 1u);
  EXPECT_EQ(hit.clusters[0].spheres, (Spheres{5, 6, 7}));
  EXPECT_EQ(hit.clusters[0].straightness, 1);
  ASSERT_EQ(hit.clusters[0].contacts.size(), 2u);
  EXPECT_EQ(hit.clusters[0].contacts[0].collisions, 8);
  EXPECT_NEAR(hit.decay.gap->ratio, 0.125, 1e-12);
  EXPECT_NEAR(hit.decay.speed->ratio, 0.4, 1e-12);
  // Flights are differences of times near 1.45, good to 2e-16, down to 2e-11.
  EXPECT_NEAR(hit.decay.flight->ratio, 0.3125, 1e-6);
  EXPECT_NEAR(hit.decay.exact->gap, 0.125, 1e-15);
  EXPECT_NEAR(hit.decay.collapse_time.value(), 1 / (1 - 0.3125), 1e-14);
  EXPECT_EQ(hit.collisions.k.front(), 1);
  EXPECT_EQ(hit.collisions.k.back(), 16);
  EXPECT_EQ(hit.collisions.time.back(), 0);
}

TEST_F(Dissecting, LooksAtTheFirstHitOnly) {
  collapse(5, 8);
  collide(5, 6, 0, 1e-6, 2);
  collide(20, 21, 0, 1e-6, 2);
  EXPECT_EQ(dissector.anatomy().hit->collision, 8);
}

TEST_F(Dissecting, DoesNotTakeTheFirstCollisionForAHit) {
  collide(0, 1, 0, 1, 0);  // the gap at the start is not one after a collision
  EXPECT_FALSE(dissector.anatomy().hit);
}

TEST_F(Dissecting, MeasuresAClusterThroughTheCollisionsOfOthers) {
  double gap = 1;
  double speed = 1;
  double time = 0;
  for (int n = 0; n < 14; ++n) {  // another pair meets before each collision of the three
    collide(80, 81, 0.3, 0.1, time + gap / speed / 2);
    time += gap / speed;
    collide(5 + n % 2, 6 + n % 2, gap / 2, speed, time);
    gap *= 0.125;
    speed *= 0.4;
  }
  collide(5, 6, 0, 1e-6, 2);
  const Dissection hit = dissector.anatomy().hit.value();
  EXPECT_EQ(hit.clusters[0].spheres, (Spheres{5, 6, 7}));
  EXPECT_NEAR(hit.decay.gap->ratio, 0.125, 1e-6);
  EXPECT_EQ(hit.collisions.k.size(), 14u);
  ASSERT_EQ(hit.clusters.size(), 2u);  // the others repeat as well
  EXPECT_EQ(hit.clusters[1].spheres, (Spheres{80, 81}));
}

TEST_F(Dissecting, TakesAPairWithItsLastCollisionForTheClusterOfAChanceHit) {
  const double root = std::sqrt(3.0) / 2;
  collide(3, 9, 0.1, 1, 0.5);
  collide(0, 1, 0.2, 1, 1, {{1, 0}});
  collide(1, 2, 0, 1, 1, {{-0.5, root}});  // the elastic triple
  const Dissection hit = dissector.anatomy().hit.value();
  EXPECT_EQ(hit.clusters[0].spheres, (Spheres{0, 1, 2}));
  EXPECT_DOUBLE_EQ(hit.clusters[0].straightness, 0.5);
  EXPECT_FALSE(hit.decay.gap);
  EXPECT_FALSE(hit.decay.collapse_time);
}

TEST_F(Dissecting, KnowsThePairBeforeWhichARunWasStopped) {
  collapse(5, 16);
  dissector.observe_next({5, 6}, 1e-3);
  EXPECT_FALSE(dissector.anatomy().hit);
  dissector.observe_next({5, 6}, -1e-17);
  EXPECT_EQ(dissector.anatomy().hit->clusters[0].spheres, (Spheres{5, 6, 7}));
}

TEST_F(Dissecting, FindsWhatLedToAnArrestOfOnePair) {
  collapse(5, 20);
  for (int n = 0; n < 5000; ++n) collide(6, 7, 0, 1e-9, 2);
  EXPECT_FALSE(dissector.anatomy().arrest);
  dissector.observe_arrest({{6, 7}});
  const Dissection arrest = dissector.anatomy().arrest.value();
  EXPECT_EQ(arrest.collision, 5020);
  EXPECT_EQ(arrest.clusters[0].spheres, (Spheres{5, 6, 7}));
  EXPECT_EQ(arrest.collisions.k.front(), 1);  // 5000 absorbed collisions have not pushed it out
  EXPECT_EQ(arrest.collisions.k.back(), 5020);
  EXPECT_NEAR(arrest.decay.gap->ratio, 0.125, 1e-12);
}

TEST_F(Dissecting, FindsBothClustersOfAnArrest) {
  for (int n = 0; n < 40; ++n) {
    collide(0, 1, 0, 1e-9, 2);
    collide(7, 8, 0, 1e-9, 2);
    collide(8, 9, 0, 1e-9, 2, {{0, 1}});
  }
  dissector.observe_arrest({{0, 1}, {7, 8}, {8, 9}});
  const Dissection arrest = dissector.anatomy().arrest.value();
  ASSERT_EQ(arrest.clusters.size(), 2u);
  EXPECT_EQ(arrest.clusters[0].spheres, (Spheres{0, 1}));
  EXPECT_EQ(arrest.clusters[1].spheres, (Spheres{7, 8, 9}));
  EXPECT_DOUBLE_EQ(arrest.clusters[1].straightness, std::sqrt(0.5));
}

TEST_F(Dissecting, DoesNotConnectSpheresThroughAWall) {
  for (int n = 0; n < 4; ++n) {
    collide(3, 100, 0, 0.1, n);
    collide(4, 100, 0, 0.1, n + 0.5);
  }
  dissector.observe_arrest({{3, 100}, {4, 100}});
  const Dissection arrest = dissector.anatomy().arrest.value();
  ASSERT_EQ(arrest.clusters.size(), 2u);
  EXPECT_EQ(arrest.clusters[0].spheres, Spheres{3});
  EXPECT_EQ(arrest.clusters[0].contacts[0].j, 100);
}

TEST_F(Dissecting, RefusesCollisionsInAnArchiveThatThereCannotBe) {
  const auto is_refused = [](const Dissector<2, double>& archived) {
    ArchiveWriter writer;
    writer(archived);
    Dissector<2, double> read{dissected_gap, 100, 1.0, 0.05};
    try {
      ArchiveReader(writer.bytes())(read);
    } catch (const ArchiveError&) {
      return true;
    }
    return false;
  };
  collide(98, 101, 1, 1, 0);  // off the upper wall
  EXPECT_FALSE(is_refused(dissector));
  for (const auto& [i, j] : {std::pair(2, 1), {3, 3}, {-1, 3}, {3, 102}, {100, 101}}) {
    dissector = {dissected_gap, 100, 1.0, 0.05};
    collide(i, j, 1, 1, 0);
    EXPECT_TRUE(is_refused(dissector));
  }
}

TEST_F(Dissecting, RefusesADissectionInAnArchiveThatThereCannotBe) {
  collapse(5, 16);
  collide(5, 6, 0, 1e-6, 2);
  const Dissection hit = dissector.anatomy().hit.value();
  ASSERT_TRUE(is_possible(hit, 2, 100));
  EXPECT_FALSE(is_possible(hit, 3, 100));  // positions of other dimensions
  EXPECT_FALSE(is_possible(hit, 2, 7));    // without sphere 7
  Dissection forged = hit;
  forged.collisions.gap.pop_back();
  EXPECT_FALSE(is_possible(forged, 2, 100));
  forged = hit;
  forged.pairs[0] = {6, 5};
  EXPECT_FALSE(is_possible(forged, 2, 100));
  forged = hit;
  forged.clusters.clear();
  EXPECT_FALSE(is_possible(forged, 2, 100));
  ArchiveWriter writer;
  writer(RecentCollisions<2, double>(dissected_gap, 1.0), Anatomy{.hit = forged, .arrest = {}});
  ArchiveReader reader(writer.bytes());
  EXPECT_THROW(reader(dissector), ArchiveError);
}

TEST_F(Dissecting, TakesNoHitBeforeTheFirstCollisionItHasSeen) {
  number = 7;  // as a forged state has it
  collide(5, 6, 0, 1, 0);
  EXPECT_FALSE(dissector.anatomy().hit);
}

/// The recent collisions of a run on a line whose gaps and times are told.
class RecentRun {
 public:
  void observe(double gap, double time) {
    ++collision_.number;
    collision_.gap_before = gap;
    collision_.time.remainder = time;
    recent.observe(collision_);
  }
  std::vector<std::int64_t> numbers() const {
    std::vector<std::int64_t> numbers;
    for (const auto& trace : recent.traces()) numbers.push_back(trace.number);
    return numbers;
  }

  RecentCollisions<1, double> recent{dissected_gap, 1.0};

 private:
  Collision<1, double> collision_;
};

TEST(RecentCollisions, KeepABoundedNumberBeforeAndSinceTheClockStopped) {
  RecentRun run;
  for (int n = 0; n < 3000; ++n) run.observe(0.1, n);
  for (int n = 0; n < 3000; ++n) run.observe(0, 3000);
  const auto numbers = run.numbers();
  EXPECT_EQ(run.recent.before_stretch(), 1024u);
  EXPECT_EQ(numbers.size(), 2048u);
  EXPECT_EQ(numbers[1023], 3000);
  EXPECT_EQ(numbers.back(), 6000);
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end(), std::less_equal<>()));
  run.observe(0, 3001);  // the clock has moved: what was a stretch has led here
  const auto later = run.numbers();
  EXPECT_EQ(later.size(), 1025u);
  EXPECT_EQ(later.front(), 6000 - 1023);
  for (std::size_t n = 1; n < later.size(); ++n) ASSERT_EQ(later[n], later[n - 1] + 1);
}

TEST(RecentCollisions, GoOnFromAnArchiveAsTheyWould) {
  // Stretches of 1, 3 and 1500 collisions, archived in the midst of each.
  for (const auto& [before, since] : {std::pair(0, 0), {0, 1}, {5, 0}, {1030, 2}, {40, 1500}}) {
    RecentRun run;
    for (int n = 0; n < before; ++n) run.observe(0.1, n);
    for (int n = 0; n < since; ++n) run.observe(0, before);
    ArchiveWriter writer;
    writer(run.recent);
    RecentRun other = run;
    other.recent = RecentCollisions<1, double>(dissected_gap, 1.0);
    ArchiveReader reader(writer.bytes());
    reader(other.recent);
    reader.require_end();
    EXPECT_EQ(other.numbers(), run.numbers()) << before << ' ' << since;
    for (RecentRun* both : {&run, &other}) {
      both->observe(0, before);
      for (int n = 0; n < 3; ++n) both->observe(0.1, before + 1 + n);
    }
    EXPECT_EQ(other.numbers(), run.numbers()) << before << ' ' << since;
  }
}

TEST(Dissection, KnowsACollapseTimeSinceTheStartToItsLastPlace) {
  Decay decay;
  decay.collapse_time = 1e18;  // of which the last place is 128
  decay.collapse_time_error = 1e-3;
  EXPECT_GE(decay.error_since_start(), 128);
  EXPECT_LE(decay.error_since_start(), 256);
}

}  // namespace
}  // namespace zenosphere
