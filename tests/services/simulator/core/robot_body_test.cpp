#include "services/simulator/core/robot_body.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

constexpr SlipModel kNoSlip{0.0, 0.0, 0.0};

Place room() {
  return Place{test::ascii_map({"######", "#....#", "#....#", "#....#", "######"})};
}

TEST(RobotBody, GoesWhereItsWheelsPushIt) {
  RobotBody body{Hull{}, kNoSlip, {2.0, 2.5, 0.0}, Rng{1}};
  EXPECT_FALSE(body.move({0.5, 0.0, 0.0}, room(), {}).blocked);
  EXPECT_EQ(body.map_from_base(), (Pose2{2.5, 2.5, 0.0}));
}

TEST(RobotBody, AWallStopsItsFront) {
  RobotBody body{Hull{}, kNoSlip, {4.5, 2.5, 0.0}, Rng{1}};  // the wall begins at 5
  const Moved moved = body.move({0.3, 0.0, 0.0}, room(), {});
  EXPECT_TRUE(moved.blocked);
  EXPECT_TRUE(moved.contact.front);
  EXPECT_FALSE(moved.contact.rear);
  EXPECT_EQ(body.map_from_base(), (Pose2{4.5, 2.5, 0.0}));
  EXPECT_EQ(body.collisions(), 1);
  (void)body.move({0.3, 0.0, 0.0}, room(), {});
  EXPECT_EQ(body.collisions(), 1);  // the same contact
}

TEST(RobotBody, ItsCornersReachFartherThanItsSides) {
  const Hull hull{1.0, 1.0};
  const Place place = room();
  EXPECT_FALSE(contact_at(hull, {2.5, 1.6, 0.0}, place, {}).any());                // 0.5 below, 0.1 left
  EXPECT_TRUE(contact_at(hull, {2.5, 1.6, from_degrees(45.0)}, place, {}).any());  // 0.71 below
}

TEST(RobotBody, APersonBehindItIsARearContactItMayLeave) {
  const Disc person{{1.6, 2.5}, 0.2};
  RobotBody body{Hull{}, kNoSlip, {2.0, 2.5, 0.0}, Rng{1}};  // the hull ends at 1.69, the person at 1.8
  const std::vector<Disc> people{person};
  EXPECT_TRUE(body.move({-0.1, 0.0, 0.0}, room(), people).blocked);
  EXPECT_FALSE(body.move({0.05, 0.0, 0.0}, room(), people).blocked);
  EXPECT_NEAR(body.map_from_base().x, 2.05, 1e-12);
}

}  // namespace
}  // namespace tandem::simulator
