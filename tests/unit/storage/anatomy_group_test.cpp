#include "storage/anatomy_group.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "storage/hdf5_series.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {
namespace {

Dissection dissection_of_two_clusters() {
  Dissection found;
  found.collision = 7;
  found.time = 0.5;
  found.pairs = {{1, 2}};
  Cluster first;
  first.spheres = {1, 2, 5};
  first.positions = {-1, 0, 0, 0, 1, 0};
  first.contacts = {{1, 2, 4}, {2, 5, 3}};
  first.chain = {1, 2, 5};
  first.bends = {0.25};
  Cluster second;
  second.spheres = {8};
  second.positions = {0, 0};
  second.contacts = {{8, 9, 6}};
  second.chain = {8};
  found.clusters = {first, second};
  found.collisions.k = {6, 7};
  found.collisions.time = {-0.1, 0};
  found.collisions.i = {1, 2};
  found.collisions.j = {2, 5};
  found.collisions.gap = {std::nan(""), 0.1};
  found.collisions.normal_speed = {1, 0.4};
  found.collisions.flight = {std::nan(""), 0.1};
  found.decay.speed = DecayRate{0.4, 0.01};
  return found;
}

TEST(AnatomyGroup, HoldsEveryClusterFlat) {
  const TemporaryFolder folder;
  const hdf5::Handle file = hdf5::created_file(folder.path / "a.h5");
  write_anatomy(file, {dissection_of_two_clusters(), std::nullopt}, 2);
  EXPECT_FALSE(hdf5::contains(hdf5::opened(file, "anatomy"), "arrest"));
  const hdf5::Handle hit = hdf5::opened(file, "anatomy/hit");
  EXPECT_EQ(hdf5::number_attribute(hit, "collision"), 7);
  using Ids = std::vector<std::int32_t>;
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "pairs"), (Ids{1, 2}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "chain"), (Ids{1, 2, 5}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "spheres/sphere"), (Ids{1, 2, 5, 8}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "spheres/cluster"), (Ids{0, 0, 0, 1}));
  EXPECT_EQ(hdf5::shape(hit, "spheres/position"), (std::vector<std::int64_t>{4, 2}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "contacts/cluster"), (Ids{0, 0, 1}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "contacts/i"), (Ids{1, 2, 8}));
  EXPECT_EQ(hdf5::values<std::int32_t>(hit, "contacts/j"), (Ids{2, 5, 9}));
  EXPECT_EQ(hdf5::values<std::int64_t>(hit, "contacts/collisions"),
            (std::vector<std::int64_t>{4, 3, 6}));
  EXPECT_EQ(hdf5::values<double>(hit, "collisions/normal_speed"), (std::vector<double>{1, 0.4}));
}

TEST(AnatomyGroup, IsAbsentWhereNothingCollapsed) {
  const TemporaryFolder folder;
  const hdf5::Handle file = hdf5::created_file(folder.path / "a.h5");
  write_anatomy(file, {}, 2);
  EXPECT_FALSE(hdf5::contains(file, "anatomy"));
}

TEST(AnatomyGroup, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const hdf5::Handle file = hdf5::created_file(folder.path / "a.h5");
  const Dissection written = dissection_of_two_clusters();
  write_anatomy(file, {written, std::nullopt}, 2);
  const Anatomy read = read_anatomy(file, 2, 10);
  EXPECT_FALSE(read.arrest);
  ASSERT_TRUE(read.hit);
  EXPECT_EQ(read.hit->collision, 7);
  EXPECT_EQ(read.hit->pairs, written.pairs);
  ASSERT_EQ(read.hit->clusters.size(), 2U);
  EXPECT_EQ(read.hit->clusters[0].positions, written.clusters[0].positions);
  EXPECT_EQ(read.hit->clusters[0].chain, written.clusters[0].chain);
  EXPECT_EQ(read.hit->clusters[1].spheres, written.clusters[1].spheres);
  const auto& contact = read.hit->clusters[1].contacts.front();
  EXPECT_EQ(contact.i, 8);
  EXPECT_EQ(contact.j, 9);
  EXPECT_EQ(contact.collisions, 6);
  EXPECT_EQ(read.hit->collisions.k, written.collisions.k);
  EXPECT_TRUE(std::isnan(read.hit->collisions.gap[0]));
  EXPECT_FALSE(read.hit->decay.gap);
  EXPECT_EQ(read.hit->decay.speed->ratio, 0.4);
  EXPECT_EQ(read.hit->decay.speed->spread, 0.01);
}

TEST(AnatomyGroup, SphereThatIsNotThereMakesADamagedFile) {
  const TemporaryFolder folder;
  const hdf5::Handle file = hdf5::created_file(folder.path / "a.h5");
  write_anatomy(file, {dissection_of_two_clusters(), std::nullopt}, 2);
  EXPECT_THROW(read_anatomy(file, 2, 8), hdf5::Error);   // it names sphere 8, counted from 0
  EXPECT_THROW(read_anatomy(file, 3, 10), hdf5::Error);  // positions are in two dimensions
}

}  // namespace
}  // namespace zenosphere
