#include "services/localization/core/pose_refinement.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

TEST(RefinePose, PullsAPoseOntoTheWalls) {
  const OccupancyGrid map = test::uneven_room();
  const DistanceField field{map, 2.0};
  Rng rng{8};
  for (int i = 0; i < 50; ++i) {
    const Pose2 truth{rng.uniform(1.5, 3.5), rng.uniform(1.0, 2.5), rng.uniform(-3.0, 3.0)};
    const auto endpoints = selected_endpoints(test::scan_from(map, truth, Time{}), 180, 25.0, {});
    const Pose2 prior{truth.x + rng.uniform(-0.1, 0.1), truth.y + rng.uniform(-0.1, 0.1),
                      truth.heading + rng.uniform(-0.05, 0.05)};

    const Pose2 refined = refine_pose(field, endpoints, prior, {}).map_from_base;

    EXPECT_LT((refined.position() - truth.position()).norm(), 0.1) << "trial " << i;
    EXPECT_LT(std::abs(turn_between(refined.heading, truth.heading)), 0.03) << "trial " << i;
  }
}

TEST(RefinePose, KeepsToThePriorAlongABlankCorridor) {
  OccupancyGrid corridor{200, 20, 0.1, {}, CellState::Free};
  for (int column = 0; column < 200; ++column) {
    corridor.set({column, 0}, CellState::Occupied);
    corridor.set({column, 19}, CellState::Occupied);
  }
  const DistanceField field{corridor, 2.0};
  const auto endpoints = selected_endpoints(test::scan_from(corridor, {10.0, 1.0, 0.0}, Time{}), 180, 5.0, {});

  const RefinedPose refined = refine_pose(field, endpoints, {10.3, 1.1, 0.0}, {});

  EXPECT_NEAR(refined.map_from_base.x, 10.3, 0.02);
  EXPECT_NEAR(refined.map_from_base.y, 1.0, 0.02);
  EXPECT_GT(refined.covariance(0, 0), 0.5 * 0.15 * 0.15);  // nearly the prior's
  EXPECT_LT(refined.covariance(1, 1), 0.1 * 0.15 * 0.15);
}

}  // namespace
}  // namespace tandem
