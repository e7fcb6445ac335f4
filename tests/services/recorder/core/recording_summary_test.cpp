#include "services/recorder/core/recording_summary.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::recorder {
namespace {

TEST(RecordingSummary, CountsEachTopicAndItsRate) {
  const mcap::Reader reader = mcap::opened(mcap::live_file(11));  // every 10 ns, for 100 ns
  const auto topics = summary_of(reader);

  ASSERT_EQ(topics.size(), 2U);
  EXPECT_EQ(topics[0].topic, "odometry");
  EXPECT_EQ(topics[0].type, "tandem::msg::Odometry");
  EXPECT_EQ(topics[0].count, 11U);
  EXPECT_EQ(topics[0].first_time_ns, 1000U);
  EXPECT_EQ(topics[0].last_time_ns, 1100U);
  EXPECT_NEAR(topics[0].rate_hz, 1e8, 1.0);
  EXPECT_EQ(topics[1].topic, "scan");
}

TEST(RecordingSummary, OneMessageHasNoRate) {
  EXPECT_DOUBLE_EQ(summary_of(mcap::opened(mcap::live_file(1)))[0].rate_hz, 0.0);
}

}  // namespace
}  // namespace tandem::recorder
