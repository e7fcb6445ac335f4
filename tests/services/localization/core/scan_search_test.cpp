#include "services/localization/core/scan_search.hpp"

#include <gtest/gtest.h>

#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

TEST(ScanSearch, FindsAPoseFarFromWhereItIsExpected) {
  const OccupancyGrid map = test::uneven_room();
  const LikelihoodField field{map, DistanceField{map, 2.0}, {}};
  const Pose2 truth{2.5, 1.5, 0.5};
  const auto endpoints = selected_endpoints(test::scan_from(map, truth, Time{}), 60, 25.0, {});

  const Pose2 found = best_pose_in_window(field, endpoints, {3.2, 1.0, 0.3}, {});

  EXPECT_NEAR(found.x, truth.x, 0.11);  // the nearest of the lattice
  EXPECT_NEAR(found.y, truth.y, 0.11);
  EXPECT_NEAR(found.heading, truth.heading, 0.06);
}

TEST(ScanSearch, StaysWhereNothingTellsPlacesApart) {
  const OccupancyGrid empty{20, 20, 0.1, {}, CellState::Free};
  const LikelihoodField field{empty, DistanceField{empty, 2.0}, {}};

  const Pose2 found = best_pose_in_window(field, std::vector<Eigen::Vector2d>{{0.3, 0.1}}, {1.0, 1.0, 0.2}, {});

  EXPECT_NEAR(found.x, 1.0, 1e-9);
  EXPECT_NEAR(found.y, 1.0, 1e-9);
  EXPECT_NEAR(found.heading, 0.2, 1e-9);
}

}  // namespace
}  // namespace tandem
