#include "services/planner/core/srs/resolved_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;

/// Shares at which agent 0 meets the boundary; the others are called "b" and "c".
std::vector<double> meetings(const Boundary& boundary, const std::vector<AgentMove>& moves, double duration_s = 1.0,
                             double level = 0.0) {
  std::vector<double> shares;
  append_level_crossings(resolved(boundary, {"a", "b", "c"}), level, 0, {moves, duration_s}, shares);
  std::sort(shares.begin(), shares.end());
  return shares;
}

TEST(ResolvedBoundary, BehindMeMovesAndTurnsWithMe) {
  const ResolvedBoundary behind = resolved(Attached{"b", HalfPlane{{-1, 0}, {1, 0}}}, {"a", "b"});
  AgentMove turning = straight_move({0, 0}, {0, 4});  // looks along y first
  turning.to_heading_rad = turning.from_heading_rad + kHalfTurn_rad;
  const std::vector<AgentMove> moves{stay_at({0, -3}), turning};

  EXPECT_NEAR(vector_to(behind, 0, {moves, 4.0}, 0.0).distance, -2.0, 1e-12);  // 2 m inside
  EXPECT_NEAR(vector_to(behind, 0, {moves, 4.0}, 1.0).distance, 8.0, 1e-12);   // 7 m ahead of b, 8 m outside
}

TEST(ResolvedBoundary, TwoWhoMoveAreMetWhereTheirRelativeWayMeets) {
  // Head on at 1 m/s each, 10 m apart: within 2 m of each other after 4 s, of 10 s.
  const auto shares = meetings(Attached{"b", Disc{{0, 0}, 2.0}},
                               {straight_move({0, 0}, {10, 0}), straight_move({10, 0}, {0, 0})}, 10.0);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_NEAR(shares[0], 0.4, 1e-12);
  EXPECT_NEAR(shares[1], 0.6, 1e-12);
}

TEST(ResolvedBoundary, ATurningFrameIsMetToTheStatedTolerance) {
  // b turns by half a turn within 2 s; a disc 2 m ahead of it sweeps over a, who stands 90 degrees to its left.
  AgentMove turning = stay_at({0, 0}, 0.0);
  turning.to_heading_rad = kHalfTurn_rad;
  const auto shares = meetings(Attached{"b", Disc{{2, 0}, 1.0}}, {stay_at({0, 2}), turning}, 2.0);

  const double half_angle_rad = 2.0 * std::asin(0.25);  // chord 1 m at radius 2 m
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_NEAR(shares[0], 0.5 - half_angle_rad / kHalfTurn_rad, 1e-11);
  EXPECT_NEAR(shares[1], 0.5 + half_angle_rad / kHalfTurn_rad, 1e-11);
}

TEST(ResolvedBoundary, ACorridorBetweenTwoIsMetThoughItStretches) {
  // From the origin to b, who walks from (4, -2) to (4, 2): its middle line passes over a at (2, 0) half way.
  const auto shares = meetings(Between{Anchor{.agent = "", .point_in_map = {0, 0}}, Anchor{.agent = "b"}, 0.5},
                               {stay_at({2, 0}), straight_move({4, -2}, {4, 2})}, 4.0);
  ASSERT_EQ(shares.size(), 2u);
  for (const double share : shares) {
    const double end_y = -2.0 + 4.0 * share;
    EXPECT_NEAR(std::abs(2.0 * end_y) / std::hypot(4.0, end_y), 0.5, 1e-9);  // distance of (2, 0) from the line
  }
}

TEST(ResolvedBoundary, ACorridorThatOnlyMovesIsMetExactly) {
  // b and c walk side by side, 2 m apart; a stands in their way.
  const auto shares =
      meetings(Between{Anchor{.agent = "b"}, Anchor{.agent = "c"}, 1.0},
               {stay_at({5, 0}), straight_move({0, -1}, {10, -1}), straight_move({0, 1}, {10, 1})}, 10.0);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_NEAR(shares[0], 0.4, 1e-15);
  EXPECT_NEAR(shares[1], 0.6, 1e-15);
}

TEST(ResolvedBoundary, SpeedsAreThoseOfTheMove) {
  const ResolvedBoundary brisk = resolved(SpeedInterval{1.0, 3.0}, {"a"});
  const std::vector<AgentMove> moves{straight_move({0, 0}, {3, 4})};
  EXPECT_DOUBLE_EQ(vector_to(brisk, 0, {moves, 2.0}, 0.5).distance, -0.5);  // 2.5 m/s
  EXPECT_DOUBLE_EQ(vector_to(brisk, 0, {moves, 1.0}, 0.5).distance, 2.0);   // 5 m/s
  EXPECT_DOUBLE_EQ(vector_to(brisk, 0, {moves, 10.0}, 0.5).distance, 0.5);  // 0.5 m/s
  EXPECT_EQ(vector_to(brisk, 0, {moves, 10.0}, 0.5).direction.x(), -1.0);
}

TEST(ResolvedBoundary, ADroneMeetsWhatHangsInTheAir) {
  AgentMove climb = stay_at({0, 0});
  climb.to_altitude_m = 10.0;
  const auto ball = meetings(Sphere{{0, 0, 5}, 2.0}, {climb});
  ASSERT_EQ(ball.size(), 2u);
  EXPECT_NEAR(ball[0], 0.3, 1e-15);
  EXPECT_NEAR(ball[1], 0.7, 1e-15);
  EXPECT_EQ(meetings(Box{{-1, -1, 2}, {1, 1, 4}}, {climb}), (std::vector<double>{0.2, 0.4}));
  EXPECT_TRUE(meetings(Box{{2, -1, 2}, {3, 1, 4}}, {climb}).empty());
}

TEST(ResolvedBoundary, MeetingsOfAnyMotionAreOnTheBoundary) {
  Rng rng{11};
  const std::vector<Boundary> boundaries{
      Attached{"b", Polygon{{{0, -1}, {3, -1}, {3, 1}, {0, 1}}}},
      Between{Anchor{.agent = "b"}, Anchor{.agent = "", .point_in_map = {1, 1}}, 0.7}};
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] { return Eigen::Vector2d{rng.uniform(-5, 5), rng.uniform(-5, 5)}; };
    AgentMove owner = straight_move(any(), any());
    owner.to_heading_rad += rng.uniform(-3, 3);
    const std::vector<AgentMove> moves{straight_move(any(), any()), owner};
    for (const auto& boundary : boundaries) {
      const ResolvedBoundary ready = resolved(boundary, {"a", "b"});
      const auto distance = [&](double share) { return vector_to(ready, 0, {moves, 5.0}, share).distance; };
      const auto shares = meetings(boundary, moves, 5.0);
      for (const double share : shares) EXPECT_NEAR(distance(share), 0.0, 1e-9) << i;
      std::size_t changes = 0;  // of 500 looks
      for (int k = 0; k < 500; ++k) changes += (distance(k / 500.0) > 0.0) != (distance((k + 1) / 500.0) > 0.0);
      EXPECT_GE(shares.size(), changes) << i;
    }
  }
}

TEST(ResolvedBoundary, ItsShapeOnTheMapIsWhereItsOwnerIs) {
  const std::vector<AgentMove> moves{absent(), stay_at({3, 4}, kHalfTurn_rad / 2)};
  const auto shape = shape_at(resolved(Attached{"b", Disc{{2, 0}, 1.0}}, {"a", "b"}), {moves, 1.0}, 0.5);
  ASSERT_TRUE(shape);
  EXPECT_NEAR((std::get<Disc>(*shape).centre - Eigen::Vector2d(3, 6)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(shape_at(resolved(Attached{"a", Disc{{2, 0}, 1.0}}, {"a", "b"}), {moves, 1.0}, 0.5));
  EXPECT_FALSE(shape_at(Nowhere{}, {moves, 1.0}, 0.5));
}

}  // namespace
}  // namespace tandem
