#include "services/planner/core/tasks/hazards.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(Hazards, CostWhatTheNegativeSourcesTakeInASecond) {
  const ResolvedWorld world{
      world_of({"a", "b"}, {disc_source("fire", {0.0, 0.0}, 2.0, -3.0), disc_source("smoke", {1.0, 0.0}, 2.0, -1.0),
                            disc_source("prize", {0.0, 0.0}, 9.0, 5.0)})};
  const Hazards hazards{world, 0, 0.0};
  EXPECT_DOUBLE_EQ(hazards.cost_per_s({0.0, 0.0}), 4.0);
  EXPECT_DOUBLE_EQ(hazards.cost_per_s({2.5, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(hazards.cost_per_s({5.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(hazards.peak_per_s(), 3.0);
}

TEST(Hazards, AddUpAlongAWay) {
  const ResolvedWorld world{world_of({"a"}, {disc_source("fire", {0.0, 0.0}, 2.0, -3.0)})};
  // From -5 to 5 at 1 m/s: 4 s inside.
  EXPECT_NEAR((Hazards{world, 0, 0.0}.along({-5.0, 0.0}, {5.0, 0.0})), 12.0, 0.3);
}

TEST(Hazards, HarmOnlyTheirTargets) {
  RewardSource fire = disc_source("fire", {0.0, 0.0}, 2.0, -3.0);
  fire.targets = {"b"};
  const ResolvedWorld world{world_of({"a", "b"}, {fire})};
  EXPECT_TRUE((Hazards{world, 0, 0.0}.empty()));
  EXPECT_FALSE((Hazards{world, 1, 0.0}.empty()));
}

TEST(Hazards, DetoursLeadAroundThemJustOutside) {
  const ResolvedWorld world{world_of({"a"}, {disc_source("fire", {1.0, 1.0}, 2.0, -3.0)})};
  const Hazards hazards{world, 0, 0.0};
  ASSERT_FALSE(hazards.detour_points().empty());
  const auto& points = hazards.detour_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_DOUBLE_EQ(hazards.along(points[i], points[(i + 1) % points.size()]), 0.0);
    EXPECT_LT((points[i] - Eigen::Vector2d{1.0, 1.0}).norm(), 2.2);
  }
}

}  // namespace
}  // namespace tandem
