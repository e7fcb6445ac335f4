#include "services/simulator/core/laser_view.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;
constexpr RangeModel kExact{.min_m = 0.02, .max_m = 30.0, .noise_m = 0.0};

Place room() {
  return Place{test::ascii_map({"######", "#....#", "#....#", "#....#", "######"})};
}

TEST(LaserView, MeasuresWalls) {
  Rng rng{1};
  const std::vector<Beam> beams{{0.0, 0.0}, {kQuarterTurn, 0.5}};
  const Pose2 pose{2.0, 2.0, 0.0};
  const auto ranges = cast(beams, pose, pose, room(), {}, kExact, rng);
  EXPECT_NEAR(ranges[0], 3.0, 1e-9);
  EXPECT_NEAR(ranges[1], 2.0, 1e-9);
}

TEST(LaserView, ALegHidesTheWall) {
  Rng rng{1};
  const std::vector<Beam> beams{{0.0, 0.0}};
  const std::vector<Disc> legs{{{4.0, 2.0}, 0.06}};
  const Pose2 pose{2.0, 2.0, 0.0};
  EXPECT_NEAR(cast(beams, pose, pose, room(), legs, kExact, rng)[0], 1.94, 1e-9);
}

TEST(LaserView, MovesDuringTheTurn) {
  Rng rng{1};
  const std::vector<Beam> beams{{0.0, 0.0}, {0.0, 0.5}, {0.0, 1.0}};
  const auto ranges = cast(beams, {2.0, 2.0, 0.0}, {3.0, 2.0, 0.0}, room(), {}, kExact, rng);
  EXPECT_NEAR(ranges[0], 3.0, 1e-9);
  EXPECT_NEAR(ranges[1], 2.5, 1e-9);
  EXPECT_NEAR(ranges[2], 2.0, 1e-9);
}

TEST(LaserView, NothingComesBackFromBeyondItsReach) {
  Rng rng{1};
  const std::vector<Beam> beams{{0.0, 0.0}};
  const Pose2 pose{2.0, 2.0, 0.0};
  EXPECT_TRUE(std::isnan(cast(beams, pose, pose, room(), {}, {.min_m = 0.02, .max_m = 2.0, .noise_m = 0.0}, rng)[0]));
}

TEST(LaserView, NoiseHasItsStandardDeviation) {
  Rng rng{4};
  const std::vector<Beam> beams(5000);
  const Pose2 pose{2.0, 2.0, 0.0};
  double squares = 0.0;
  for (const double range : cast(beams, pose, pose, room(), {}, {.noise_m = 0.01}, rng)) {
    squares += (range - 3.0) * (range - 3.0);
  }
  EXPECT_NEAR(std::sqrt(squares / 5000.0), 0.01, 0.0005);
}

TEST(LaserView, ARayMeetsTheNearSideOfADisc) {
  const Disc disc{{3.0, 4.0}, 1.0};
  EXPECT_NEAR(range_to_disc_m({0.0, 0.0}, std::atan2(4.0, 3.0), disc), 4.0, 1e-12);
  EXPECT_TRUE(std::isinf(range_to_disc_m({0.0, 0.0}, 0.0, disc)));
  EXPECT_TRUE(std::isinf(range_to_disc_m({0.0, 0.0}, std::atan2(-4.0, -3.0), disc)));
  EXPECT_EQ(range_to_disc_m({3.0, 4.5}, 0.0, disc), 0.0);
}

}  // namespace
}  // namespace tandem::simulator
