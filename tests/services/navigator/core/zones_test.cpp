#include "services/navigator/core/zones.hpp"

#include <gtest/gtest.h>

#include "services/mapping/core/map_zones.hpp"
#include "tests/services/navigator/core/driving.hpp"

namespace tandem::navigator {
namespace {

const std::vector<Wall> kHall = box(-10.0, -10.0, 20.0, 10.0);

MapArea rectangle(double left, double bottom, double right, double top, AreaRule rule, double max_speed_mps = 0.0) {
  return {"zone", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}, rule, max_speed_mps};
}

TEST(Zones, AreOutlinesInTheFrameOfTheBaseWhereTheyKeepOut) {
  const Zones zones{{rectangle(2.0, 0.0, 4.0, 2.0, AreaRule::KeepOut),
                     rectangle(0.0, 0.0, 1.0, 1.0, AreaRule::Slow, 0.2),
                     rectangle(90.0, 0.0, 94.0, 2.0, AreaRule::KeepOut)}};
  std::vector<Eigen::Vector2d> obstacles{{9.0, 9.0}};
  zones.add_outlines({2.0, 0.0, from_degrees(90.0)}, obstacles);
  ASSERT_EQ(obstacles.size(), 81u) << "80 points along 8 m, and what was there before";
  EXPECT_NEAR(obstacles[1].norm(), 0.0, 1e-9) << "its first corner is where the base stands";
  EXPECT_NEAR((obstacles[1 + 20] - Eigen::Vector2d(0.0, -2.0)).norm(), 0.0, 1e-9) << "the next is at its right hand";
}

TEST(Zones, LimitTheSpeedToWhatBrakesToTheirsAtTheirEdge) {
  const Zones zones{{rectangle(2.0, -1.0, 4.0, 1.0, AreaRule::Slow, 0.3)}};
  EXPECT_DOUBLE_EQ(zones.speed_limit_mps({3.0, 0.0}, 0.4, 0.5), 0.3);
  EXPECT_DOUBLE_EQ(zones.speed_limit_mps({1.7, 0.0}, 0.4, 0.5), 0.3) << "the hull is in it";
  EXPECT_NEAR(zones.speed_limit_mps({1.44, 0.0}, 0.4, 0.5), 0.5, 1e-9) << "0.3^2 + 2 0.5 0.16 = 0.5^2";
  EXPECT_EQ(Zones{}.speed_limit_mps({3.0, 0.0}, 0.4, 0.5), std::numeric_limits<double>::infinity());
}

TEST(Zones, AreDrivenAroundLikeThingsInTheWay) {
  const MapArea keep_out = rectangle(2.9, -0.1, 3.1, 0.1, AreaRule::KeepOut);
  Drive drive{{}, kHall, {0.0, 0.0, 0.0}, LinkLoss::Stop, {keep_out}};
  drive.accept({{0.0, 0.0}, {6.0, 0.0}});
  double nearest_m = 9.0;
  EXPECT_TRUE(drive.drive_until(60.0, [&](const Decision& decision) {
    nearest_m = std::min(nearest_m, distance_to_area_m(keep_out, drive.pose().position()));
    return decision.execution.finished;
  }));
  EXPECT_GT(nearest_m, 0.25) << "half its width";
}

TEST(Zones, ThatLieAcrossAPathBlockItAndAreNeverEntered) {
  const MapArea keep_out = rectangle(3.0, -10.0, 4.0, 10.0, AreaRule::KeepOut);
  Drive drive{{}, kHall, {0.0, 0.0, 0.0}, LinkLoss::Stop, {keep_out}};
  drive.accept({{0.0, 0.0}, {6.0, 0.0}});
  EXPECT_TRUE(drive.drive_until(60.0, [](const Decision& decision) { return decision.execution.blocked; }));
  EXPECT_GT(distance_to_area_m(keep_out, drive.pose().position()), 0.3);
}

TEST(Zones, AreCrossedNoFasterThanTheyAllow) {
  const MapArea slow = rectangle(2.0, -2.0, 4.0, 2.0, AreaRule::Slow, 0.2);
  Drive drive{{}, kHall, {0.0, 0.0, 0.0}, LinkLoss::Stop, {slow}};
  drive.accept({{0.0, 0.0}, {7.0, 0.0}});
  double fastest_mps = 0.0;
  double fastest_inside_mps = 0.0;
  EXPECT_TRUE(drive.drive_until(60.0, [&](const Decision& decision) {
    const bool inside = distance_to_area_m(slow, drive.pose().position()) < 0.3;
    (inside ? fastest_inside_mps : fastest_mps) =
        std::max(inside ? fastest_inside_mps : fastest_mps, decision.velocity.forward_mps);
    return decision.execution.finished;
  }));
  EXPECT_LE(fastest_inside_mps, 0.2 + 1e-9);
  EXPECT_GT(fastest_mps, 0.45);
}

}  // namespace
}  // namespace tandem::navigator
