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

TEST(FetchQueue, TakesManyTogetherOrNone) {
  const std::vector<double> numbers(1000);
  FetchQueue queue;
  std::uint32_t asked = 0;
  const auto address = [&](std::uint32_t k) {
    EXPECT_EQ(k, asked++);
    return &numbers[k];
  };
  queue.add_each(200, address);
  EXPECT_EQ(asked, 200u);
  EXPECT_EQ(queue.size(), 200u);
  asked = 0;
  queue.add_each(100, address);
  EXPECT_EQ(asked, 100u);
  EXPECT_EQ(queue.size(), 256u);
  asked = 0;
  queue.add_each(257, address);
  EXPECT_EQ(asked, 0u);
}

}  // namespace
}  // namespace zenosphere
