#include "services/localization/core/last_pose.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

const LastPose kLast{Time{from_seconds(100.0)}, "abc", {{1.25, -2.5, 0.1}, {7.0, 8.0, -3.0}, 4}};

/// On the same map, `age_s` later; fresh up to 5 s, of use up to 60 s.
MemoryRule after(double age_s) {
  return {"abc", kLast.time + from_seconds(age_s), from_seconds(5.0), from_seconds(60.0)};
}

std::string why_not(const std::string& text, const MemoryRule& rule) {
  const auto memory = memory_of(text, rule);
  const auto* why = std::get_if<std::string>(&memory);
  return why != nullptr ? *why : "";
}

TEST(LastPose, ComesBackAsItWasKept) {
  const auto memory = memory_of(to_text(kLast), after(1.0));

  const auto* use = std::get_if<MemoryUse>(&memory);
  ASSERT_NE(use, nullptr);
  EXPECT_EQ(use->pose.map_from_base, kLast.pose.map_from_base);
  EXPECT_EQ(use->pose.odom_from_base, kLast.pose.odom_from_base);
  EXPECT_EQ(use->pose.odometry_epoch, 4);
  EXPECT_EQ(use->memory, Memory::Fresh);
}

TEST(LastPose, IsOldAfterAFewSecondsAndOfNoUseAfterLong) {
  EXPECT_EQ(std::get<MemoryUse>(memory_of(to_text(kLast), after(6.0))).memory, Memory::Old);
  EXPECT_EQ(why_not(to_text(kLast), after(61.0)), "it is 61 s old");
  EXPECT_EQ(why_not(to_text(kLast), after(-2.0)), "it is from the future");
}

TEST(LastPose, BelongsToOneMap) {
  MemoryRule rule = after(1.0);
  rule.map_sha256 = "def";
  EXPECT_EQ(why_not(to_text(kLast), rule), "it belongs to another map");
}

TEST(LastPose, IsRefusedWhereverItsFileIsCutOff) {
  const std::string text = to_text(kLast);
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {  // but for the end of the line
    EXPECT_NE(why_not(text.substr(0, length), after(1.0)), "") << length;
  }
}

TEST(LastPose, IsRefusedIfItIsNotWhatWeWrite) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = to_text(kLast);
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(why_not(with("pose 1", "pose 2"), after(1.0)), "");
  EXPECT_NE(why_not(with("1.25", "null"), after(1.0)), "");
  EXPECT_NE(why_not(with("1.25", "\"1.25\""), after(1.0)), "");
  EXPECT_NE(why_not(with("1.25,", ""), after(1.0)), "");
  EXPECT_NE(why_not(with("odometry_epoch", "epoch"), after(1.0)), "");
  EXPECT_NE(why_not("[]", after(1.0)), "");
}

}  // namespace
}  // namespace tandem
