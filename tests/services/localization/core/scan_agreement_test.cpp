#include "services/localization/core/scan_agreement.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(ScanAgreement, IsTheShareOfBeamsThatEndAtAWall) {
  const OccupancyGrid map = test::ascii_map({"....#"});
  const DistanceField distances{map};
  const Points endpoints{{1.9, 0.0}, {1.0, 0.0}};

  EXPECT_DOUBLE_EQ(agreement_of(map, distances, {2.5, 0.5, 0.0}, {0.0, 0.0}, endpoints, 0.2), 0.5);
  EXPECT_DOUBLE_EQ(agreement_of(map, distances, {2.5, 0.5, 0.0}, {0.0, 0.0}, {}, 0.2), 0.0);
}

TEST(ScanAgreement, DoesNotCountABeamThatCameThroughAWall) {
  const OccupancyGrid map = test::ascii_map({"..#..#"});
  const DistanceField distances{map};

  EXPECT_DOUBLE_EQ(agreement_of(map, distances, {0.5, 0.5, 0.0}, {0.0, 0.0}, Points{{4.9, 0.0}}, 0.2), 0.0);
  EXPECT_DOUBLE_EQ(agreement_of(map, distances, {3.5, 0.5, 0.0}, {0.0, 0.0}, Points{{1.9, 0.0}}, 0.2), 1.0);
}

TEST(ScanAgreement, LooksFromWhereTheLaserIs) {
  const OccupancyGrid map = test::ascii_map({"..#..#"});
  const DistanceField distances{map};

  // The base is behind the wall, the laser 3 m ahead of it.
  EXPECT_DOUBLE_EQ(agreement_of(map, distances, {0.5, 0.5, 0.0}, {3.0, 0.0}, Points{{4.9, 0.0}}, 0.2), 1.0);
}

}  // namespace
}  // namespace tandem
