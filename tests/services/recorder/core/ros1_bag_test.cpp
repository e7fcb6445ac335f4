#include "services/recorder/core/ros1_bag.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/ros1_bags.hpp"

namespace tandem::ros {
namespace {

const std::vector<BagLine> kLines{{"/scan", "sensor_msgs/LaserScan", 5, {1, 2, 3}},
                                  {"/odom", "nav_msgs/Odometry", 6, mcap::Bytes(5000, 7)}};

/// `topic type time size;` of each message.
std::string read_all(const mcap::Bytes& bytes) {
  std::string text;
  const auto source = mcap::memory_source(bytes);
  read_ros1_bag(*source, "a.bag", [&text](const BagMessage& message) {
    text += message.topic + " " + message.type + " " + std::to_string(message.time_ns) + " " +
            std::to_string(message.data.size()) + ";";
  });
  return text;
}

TEST(Ros1Bag, GivesItsMessagesHoweverItIsCompressed) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    EXPECT_EQ(read_all(ros1_bag(kLines, compression)),
              "/scan sensor_msgs/LaserScan 5250000000 3;/odom nav_msgs/Odometry 6250000000 5000;")
        << compression;
  }
}

TEST(Ros1Bag, CutShortItGivesItsWholeChunks) {
  const mcap::Bytes whole = ros1_bag(kLines, "none");
  for (std::size_t length = 13; length < whole.size(); length += 11) {
    const std::string text = read_all({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_TRUE(text.empty() || text == read_all(whole)) << length;
  }
}

TEST(Ros1Bag, WhatIsDamagedIsRefusedWithItsPlace) {
  mcap::Bytes damaged = ros1_bag(kLines, "bz2");
  damaged[damaged.size() - 100] ^= 0x10;
  EXPECT_THROW(
      {
        try {
          (void)read_all(damaged);
        } catch (const BagError& error) {
          EXPECT_EQ(std::string{error.what()}.find("a.bag: byte "), 0U) << error.what();
          throw;
        }
      },
      BagError);
  EXPECT_THROW((void)read_all({'#', 'R', 'O', 'S'}), BagError);
}

}  // namespace
}  // namespace tandem::ros
