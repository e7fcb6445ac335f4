#include "services/recorder/core/disposed_record.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

TEST(DisposedRecord, BelongsToTheTopicBeforeItsSuffix) {
  EXPECT_EQ(disposed_topic("teammates#disposed"), "teammates");
  EXPECT_EQ(disposed_topic("teammates"), std::nullopt);
}

TEST(DisposedRecord, HoldsAKeyOfSixteenBytesOrNone) {
  mcap::Bytes data(16, 7);
  ASSERT_TRUE(disposed_key(data));
  EXPECT_EQ(disposed_key(data)->at(15), 7);
  data.pop_back();
  EXPECT_FALSE(disposed_key(data));
}

}  // namespace
}  // namespace tandem::recorder
