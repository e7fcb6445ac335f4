#include "services/localization/core/likelihood_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

LikelihoodField field_of(const OccupancyGrid& grid) {
  return {grid, DistanceField{grid}, BeamModel{.hit_deviation_m = 1.0, .random_share = 0.5}};
}

TEST(LikelihoodField, IsHighestOnAWall) {
  const LikelihoodField field = field_of(test::ascii_map({"....#"}));
  const std::vector<Eigen::Vector2d> beam{{2.0, 0.0}};

  EXPECT_NEAR(field.mean_log_likelihood({2.5, 0.5, 0.0}, beam), 0.0, 1e-6);  // ends on the wall
  EXPECT_NEAR(field.mean_log_likelihood({1.5, 0.5, 0.0}, beam), std::log(0.5 * std::exp(-0.5) + 0.5), 1e-6);
}

TEST(LikelihoodField, GivesAnyBeamTheShareOfRandomReturns) {
  const LikelihoodField field = field_of(test::ascii_map({"....#"}));
  const std::vector<Eigen::Vector2d> beam{{200.0, 0.0}};

  EXPECT_NEAR(field.mean_log_likelihood({0.5, 0.5, 0.0}, beam), std::log(0.5), 1e-6);
}

TEST(LikelihoodField, TurnsWithTheGridAndTheRobot) {
  const Pose2 map_from_grid{3.0, -2.0, 0.8};
  const LikelihoodField field = field_of(test::ascii_map({"....#"}, 1.0, map_from_grid));
  const std::vector<Eigen::Vector2d> beam{{0.0, -2.0}};  // to the right

  const Pose2 grid_from_base{2.5, 0.5, std::numbers::pi / 2.0};
  EXPECT_NEAR(field.mean_log_likelihood(map_from_grid * grid_from_base, beam), 0.0, 1e-6);
}

}  // namespace
}  // namespace tandem
