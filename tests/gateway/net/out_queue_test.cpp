#include "gateway/net/out_queue.hpp"

#include <gtest/gtest.h>

namespace tandem::net {
namespace {

TEST(OutQueue, GivesMessagesInOrderAndBeforeTopics) {
  OutQueue queue{10, 100};
  queue.set_latest("state", {false, "s1"});
  ASSERT_TRUE(queue.push({false, "a"}));
  ASSERT_TRUE(queue.push({false, "b"}));
  EXPECT_EQ(queue.take()->data, "a");
  EXPECT_EQ(queue.take()->data, "b");
  EXPECT_EQ(queue.take()->data, "s1");
  EXPECT_FALSE(queue.take());
}

TEST(OutQueue, KeepsOnlyTheNewestOfATopic) {
  OutQueue queue{10, 100};
  queue.set_latest("state", {false, "old"});
  queue.set_latest("state", {false, "new"});
  EXPECT_EQ(queue.coalesced(), 1u);
  EXPECT_EQ(queue.take()->data, "new");
  EXPECT_FALSE(queue.take());
}

TEST(OutQueue, RefusesMoreMessagesThanFit) {
  OutQueue by_count{2, 100};
  EXPECT_TRUE(by_count.push({false, "a"}));
  EXPECT_TRUE(by_count.push({false, "b"}));
  EXPECT_FALSE(by_count.push({false, "c"}));

  OutQueue by_size{10, 4};
  EXPECT_TRUE(by_size.push({false, "123"}));
  EXPECT_FALSE(by_size.push({false, "45"}));
  (void)by_size.take();
  EXPECT_TRUE(by_size.push({false, "45"}));
}

}  // namespace
}  // namespace tandem::net
