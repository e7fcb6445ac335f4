#include "services/relay/relay_messages.hpp"

#include <gtest/gtest.h>

#include "services/mapping/map_messages.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

TEST(RelayMessages, AHeartbeatComesBackAsItWas) {
  const Heartbeat sent{"robot1", 7, from_stamp_ns(1), "laptop1", 6, from_stamp_ns(2), Duration{3}};
  const Heartbeat received = from_message(to_message(sent, "robot"));

  EXPECT_EQ(received.host, "robot1");
  EXPECT_EQ(received.sequence_number, 7U);
  EXPECT_EQ(to_stamp_ns(received.sent), 1);
  EXPECT_EQ(received.heard_host, "laptop1");
  EXPECT_EQ(received.heard_sequence_number, 6U);
  EXPECT_EQ(to_stamp_ns(received.heard_sent), 2);
  EXPECT_EQ(received.held.count(), 3);
}

TEST(RelayMessages, AThinnedScanKeepsItsGeometry) {
  msg::LaserScan scan;
  scan.angle_min_rad(-1.0);
  scan.angle_increment_rad(0.01);
  for (int i = 0; i < 361; ++i) scan.ranges_m().push_back(static_cast<float>(i));

  const auto thin = thinned(scan, 180);

  ASSERT_EQ(thin.ranges_m().size(), 121U);  // every third
  EXPECT_DOUBLE_EQ(thin.angle_min_rad(), -1.0);
  EXPECT_DOUBLE_EQ(thin.angle_increment_rad(), 0.03);
  EXPECT_FLOAT_EQ(thin.ranges_m()[2], 6.0F);
}

TEST(RelayMessages, AScanThatFitsIsLeftAlone) {
  msg::LaserScan scan;
  scan.ranges_m(std::vector<float>(180, 1.0F));
  EXPECT_EQ(thinned(scan, 180), scan);
}

TEST(RelayMessages, AMapComesBackAsItWasAndSmaller) {
  const auto map = to_message(test::ascii_map(std::vector<std::string>(50, std::string(50, '.'))), "room");
  const auto sent = packed(map);
  EXPECT_LT(sent.zstd_cells().size(), 100U);
  EXPECT_EQ(unpacked(sent), map);
}

TEST(RelayMessages, AMapThatDoesNotFitItsHashOrItsSizeIsNone) {
  const auto sent = packed(to_message(test::ascii_map({"###", "#.#", "###"}), "room"));
  ASSERT_TRUE(unpacked(sent).has_value());
  auto other_size = sent;
  other_size.width(4);
  auto other_hash = sent;
  other_hash.sha256("0123");
  auto cut_off = sent;
  cut_off.zstd_cells().pop_back();
  for (const auto& wrong : {other_size, other_hash, cut_off}) EXPECT_FALSE(unpacked(wrong).has_value());
}

}  // namespace
}  // namespace tandem
