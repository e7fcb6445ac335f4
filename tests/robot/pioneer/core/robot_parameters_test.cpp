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

TEST(RobotParameters, SonarsSitInPairsToTheLeftAndToTheRight) {
  for (const auto& parameters : all_robot_parameters()) {
    const auto sonars = sonar_poses(parameters);
    if (sonars.empty()) continue;
    EXPECT_EQ(sonars.size(), static_cast<std::size_t>(parameters.sonars)) << parameters.subclass;
    EXPECT_GT(sonars[0].y, 0.0) << "the first is at the front left";
    double sum_y = 0.0;
    for (const auto& sonar : sonars) sum_y += sonar.y;
    EXPECT_NEAR(sum_y, 0.0, 1e-9) << parameters.subclass;
  }
  EXPECT_DOUBLE_EQ(sonar_poses(*robot_parameters("p3dx"))[3].x, 0.166);
  EXPECT_DOUBLE_EQ(sonar_poses(*robot_parameters("p2at"))[3].x, 0.245);
  EXPECT_TRUE(sonar_poses(*robot_parameters("pion1x")).empty());
}

}  // namespace
}  // namespace tandem::pioneer
