#include "services/bus/mailbox.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

RawSample sample(std::uint8_t key, std::uint8_t content) {
  RawSample made;
  made.key[0] = key;
  made.payload = {content};
  return made;
}

TEST(LatestBox, KeepsTheNewestOfEachInstance) {
  LatestBox box;
  box.put(sample(1, 10));
  box.put(sample(2, 20));
  box.put(sample(1, 11));

  ASSERT_EQ(box.each().size(), 2U);
  EXPECT_EQ(box.each()[0].payload[0], 11);
  EXPECT_EQ(box.each()[1].payload[0], 20);
  EXPECT_EQ(box.newest()->payload[0], 11);
  EXPECT_EQ(box.count(), 3U);
}

TEST(LatestBox, GivesANewSampleOnce) {
  LatestBox box;
  EXPECT_FALSE(box.take_new());
  box.put(sample(1, 10));
  EXPECT_TRUE(box.take_new());
  EXPECT_FALSE(box.take_new());
  EXPECT_TRUE(box.newest());
}

TEST(LatestBox, ForgetsAnInstanceThatEnded) {
  LatestBox box;
  box.put(sample(1, 10));
  RawSample end = sample(1, 0);
  end.kind = RawSample::Kind::Disposed;
  box.put(end);

  EXPECT_TRUE(box.each().empty());
  EXPECT_FALSE(box.newest());
  ASSERT_EQ(box.gone().size(), 1U);
}

TEST(LatestBox, MarksAnInstanceWithoutAWriterUntilTheWriterIsBack) {
  LatestBox box;
  box.put(sample(1, 10));
  RawSample news = sample(1, 0);
  news.kind = RawSample::Kind::NoWriter;
  box.put(news);
  ASSERT_EQ(box.each().size(), 1U);
  EXPECT_FALSE(box.each()[0].writer_alive);
  EXPECT_FALSE(box.newest()->writer_alive);
  EXPECT_EQ(box.newest()->payload[0], 10);

  news.kind = RawSample::Kind::WriterBack;
  box.put(news);
  EXPECT_TRUE(box.each()[0].writer_alive);
  EXPECT_TRUE(box.newest()->writer_alive);
  EXPECT_TRUE(box.gone().empty());
}

TEST(InOrderBox, KeepsEverySampleUntilItsLimitAndCountsTheRest) {
  InOrderBox box{2};
  for (std::uint8_t i = 1; i <= 3; ++i) box.put(sample(0, i));

  const auto taken = box.take();
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].payload[0], 2);  // the oldest went
  EXPECT_EQ(box.dropped(), 1U);
  EXPECT_TRUE(box.take().empty());
}

}  // namespace
}  // namespace tandem::bus
