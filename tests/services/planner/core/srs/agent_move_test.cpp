#include "services/planner/core/srs/agent_move.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

TEST(AgentMove, LooksWhereItGoes) {
  EXPECT_DOUBLE_EQ(straight_move({0, 0}, {0, 2}).to_heading_rad, std::numbers::pi / 2);
}

TEST(AgentMove, APartOfItIsAMove) {
  AgentMove move = straight_move({0, 0}, {8, 0});
  move.to_altitude_m = 4.0;
  move.to_heading_rad = 2.0;
  const AgentMove part = part_of(move, 0.25, 0.5);
  EXPECT_EQ(part.from_in_map, Eigen::Vector2d(2, 0));
  EXPECT_EQ(part.to_in_map, Eigen::Vector2d(4, 0));
  EXPECT_DOUBLE_EQ(part.to_altitude_m, 2.0);
  EXPECT_DOUBLE_EQ(part.from_heading_rad, 0.5);
}

}  // namespace
}  // namespace tandem
