#include "services/recorder/core/topic_choice.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

TEST(TopicChoice, AStarIsAnyTextAndAQuestionMarkOneCharacter) {
  EXPECT_TRUE(matches("scan", "scan"));
  EXPECT_FALSE(matches("scan", "scans"));
  EXPECT_FALSE(matches("scans", "scan"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("link_*", "link_status"));
  EXPECT_FALSE(matches("link_*", "blink_status"));
  EXPECT_TRUE(matches("*_status", "planner_status"));
  EXPECT_TRUE(matches("*a*b", "xaxbxab"));
  EXPECT_FALSE(matches("*a*b", "xaxbxa"));
  EXPECT_TRUE(matches("sc?n", "scan"));
  EXPECT_FALSE(matches("sc?n", "scn"));
}

TEST(TopicChoice, WithoutAnyPatternAllAreChosenButThoseThatAreLeftOut) {
  EXPECT_TRUE(is_chosen("scan", {}, {}));
  EXPECT_FALSE(is_chosen("camera_image", {}, {"camera_*"}));
  EXPECT_FALSE(is_chosen("scan", {"odometry", "link_*"}, {}));
  EXPECT_TRUE(is_chosen("link_status", {"odometry", "link_*"}, {}));
  EXPECT_FALSE(is_chosen("link_status", {"odometry", "link_*"}, {"*_status"}));
}

}  // namespace
}  // namespace tandem::recorder
