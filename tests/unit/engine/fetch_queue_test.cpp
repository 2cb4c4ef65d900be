#include "engine/fetch_queue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zenosphere {
namespace {

TEST(FetchQueue, FetchesAsManyAsItIsAskedForAndHas) {
  const std::vector<double> numbers(100);
  FetchQueue queue;
  for (const double& number : numbers) queue.add(&number);
  EXPECT_EQ(queue.size(), 100u);
  queue.fetch(30);
  EXPECT_EQ(queue.size(), 70u);
  queue.fetch(71);
  EXPECT_EQ(queue.size(), 0u);
  queue.fetch(1);
  EXPECT_EQ(queue.size(), 0u);
}

TEST(FetchQueue, FetchesTheFirstAtOnceWhereThereAreTooMany) {
  const double number = 0;
  FetchQueue queue;
  for (int k = 0; k < 100'000; ++k) {
    queue.add(&number);
    ASSERT_LE(queue.size(), 256u);
  }
}

}  // namespace
}  // namespace zenosphere
