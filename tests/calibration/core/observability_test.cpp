#include "calibration/core/observability.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem {
namespace {

DrivenMotion plenty() {
  return {.pairs = 100, .straight_m = 20.0, .left_rad = 10.0, .right_rad = 10.0};
}

TEST(Observability, CountsWhatTheScansSay) {
  const std::vector<MotionPair> pairs{
      {.motion = {0.4, 0.0, 0.0}}, {.motion = {0.0, 0.0, 0.5}}, {.motion = {0.3, 0.0, -0.4}}};
  const DrivenMotion motion = driven_motion(pairs);
  EXPECT_EQ(motion.pairs, 3u);
  EXPECT_DOUBLE_EQ(motion.straight_m, 0.4);  // the others turned
  EXPECT_DOUBLE_EQ(motion.left_rad, 0.5);
  EXPECT_DOUBLE_EQ(motion.right_rad, 0.4);
}

TEST(Observability, AsksForNothingWhereThereIsEnough) {
  EXPECT_TRUE(missing_motion(plenty(), {}, false).empty());
}

TEST(Observability, SaysWhichMotionIsMissing) {
  DrivenMotion motion = plenty();
  motion.straight_m = 1.5;
  motion.left_rad = 0.0;
  const auto missing = missing_motion(motion, {}, false);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_NE(missing[0].find("drive straight at least 5 m: it drove 1.5 m"), std::string::npos);
  EXPECT_NE(missing[1].find("turn both ways: to the left"), std::string::npos);
}

TEST(Observability, NeedsTurnsToOneSideOnlyForTheLaserAlone) {
  DrivenMotion motion = plenty();
  motion.left_rad = 0.0;
  EXPECT_TRUE(missing_motion(motion, {}, true).empty());
}

TEST(Observability, RefusesANumberThatIsNotKnownAndSaysWhatHelps) {
  std::vector<ParameterKnowledge> known = knowledge_of({}, false);
  EXPECT_TRUE(missing_motion(plenty(), known, false).empty());
  known.back().deviation = 60.0;  // ms, of the laser's clock
  const auto missing = missing_motion(plenty(), known, false);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].find("start and stop turning"), std::string::npos);
  known.back().deviation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(missing_motion(plenty(), known, false).size(), 1u);
}

TEST(Observability, AsksNothingOfWheelsThatAreHeld) {
  std::vector<ParameterKnowledge> known = knowledge_of({}, true);
  known.front().deviation = 1.0;
  EXPECT_TRUE(missing_motion(plenty(), known, true).empty());
}

}  // namespace
}  // namespace tandem
