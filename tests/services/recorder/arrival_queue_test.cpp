#include "services/recorder/arrival_queue.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

Arrival arrival(std::size_t source, int time_ns, std::size_t size = 1) {
  Arrival one;
  one.source = source;
  one.payload.resize(size);
  one.received = Time{std::chrono::nanoseconds{time_ns}};
  return one;
}

TEST(ArrivalQueue, GivesWhatCameInOrderOfArrivalOverAllTopics) {
  ArrivalQueue queue{2, 10, 100};
  queue.put(arrival(0, 1));
  queue.put(arrival(1, 3));
  queue.put(arrival(0, 2));
  const auto taken = queue.take();
  ASSERT_EQ(taken.size(), 3U);
  EXPECT_EQ(taken[1].source, 0U);
  EXPECT_EQ(taken[2].source, 1U);
  EXPECT_TRUE(queue.take().empty());
}

TEST(ArrivalQueue, CountsWhatItHasNoRoomForByTopic) {
  ArrivalQueue queue{2, 2, 100};
  for (int i = 0; i < 5; ++i) queue.put(arrival(0, i));
  queue.put(arrival(1, 6, 98));
  queue.put(arrival(1, 7, 1));  // 101 bytes
  EXPECT_EQ(queue.dropped(), (std::vector<std::uint64_t>{3, 1}));
  EXPECT_EQ(queue.take().size(), 3U);
  queue.put(arrival(0, 8));  // there is room again
  EXPECT_EQ(queue.dropped(), (std::vector<std::uint64_t>{3, 1}));
  EXPECT_EQ(queue.take().size(), 1U);
}

TEST(ArrivalQueue, AWriterThatEndsIsNoMessage) {
  ArrivalQueue queue{1, 10, 100};
  ArrivalBox box{queue, 0};
  bus::RawSample sample;
  sample.kind = bus::RawSample::Kind::NoWriter;
  box.put(sample);
  sample.kind = bus::RawSample::Kind::Disposed;
  box.put(sample);
  const auto taken = queue.take();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_TRUE(taken[0].disposed);
}

}  // namespace
}  // namespace tandem::recorder
