#include "robot/pioneer/core/robot_parameters.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

TEST(RobotParameters, KnowsARobotInAnyCase) {
  ASSERT_NE(robot_parameters("P2AT"), nullptr);
  EXPECT_DOUBLE_EQ(robot_parameters("P2AT")->metres_per_count, 0.00132);
  EXPECT_EQ(robot_parameters("p9zz"), nullptr);
}

TEST(RobotParameters, TellsModelsApartWhoseDistancesDifferByAFactor) {
  EXPECT_DOUBLE_EQ(robot_parameters("p2at8+")->metres_per_count, 0.000465);
  EXPECT_DOUBLE_EQ(robot_parameters("p3at-sh")->metres_per_count, 0.001);
}

TEST(RobotParameters, AreSaneForEveryModel) {
  for (const RobotParameters& model : all_robot_parameters()) {
    SCOPED_TRACE(model.subclass);
    EXPECT_GT(model.metres_per_count, 0.0);
    EXPECT_GT(model.length_m, model.width_m);
    EXPECT_GT(model.half_track_per_m, 1.0);
    EXPECT_EQ(robot_parameters(model.subclass), &model);
  }
}

}  // namespace
}  // namespace tandem::pioneer
