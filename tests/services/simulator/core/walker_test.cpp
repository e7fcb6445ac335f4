#include "services/simulator/core/walker.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

Place hall() {
  return Place{test::ascii_map({"############", "#....#.....#", "#....#.....#", "#..........#", "############"})};
}

TEST(Walker, WalksStraightAtItsSpeed) {
  Walker walker{{2.5, 2.5, 0.0}};
  EXPECT_FALSE(walker.walk({4.5, 2.5}, 0.75, 1.0, hall(), {}));
  EXPECT_NEAR(walker.map_from_person().x, 3.25, 1e-12);
  EXPECT_NEAR(walker.map_from_person().y, 2.5, 1e-12);
  EXPECT_EQ(walker.speed_mps(), 0.75);
}

TEST(Walker, ItsLegsAreThirtyCentimetresApartAndSwing) {
  Walker walker{{2.5, 2.5, 0.0}};
  const auto standing = walker.legs();
  EXPECT_NEAR(standing[0].centre_in_map.y(), 2.65, 1e-12);
  EXPECT_NEAR(standing[1].centre_in_map.y(), 2.35, 1e-12);
  EXPECT_EQ(standing[0].radius_m, 0.06);
  double widest = 0.0;
  for (int i = 0; i < 40; ++i) {
    (void)walker.walk({4.5, 2.5}, 0.75, 0.025, hall(), {});
    const auto legs = walker.legs();
    EXPECT_NEAR((legs[0].centre_in_map - legs[1].centre_in_map).norm(), 0.3, 1e-9);
    widest = std::max(widest, std::abs(legs[0].centre_in_map.x() - legs[1].centre_in_map.x()));
  }
  EXPECT_GT(widest, 0.2);
}

TEST(Walker, GoesRoundWhoStandsInTheWay) {
  const std::vector<Disc> others{{{4.0, 1.6}, 0.3}};
  Walker walker{{2.5, 1.5, 0.0}};
  bool arrived = false;
  for (int i = 0; i < 400 && !arrived; ++i) {
    arrived = walker.walk({6.5, 1.6}, 0.75, 0.025, hall(), others);
    EXPECT_GT((walker.map_from_person().position() - others[0].centre_in_map).norm(), 0.5);
    EXPECT_GT(hall().clearance_m(walker.map_from_person().position()), 0.2);
  }
  EXPECT_TRUE(arrived);
}

TEST(Route, LeadsRoundWallsToItsEnd) {
  Walker walker{{2.5, 3.5, 0.0}};
  Route route{{{8.5, 3.5}}};
  for (int i = 0; i < 1200 && !route.finished(); ++i) {
    route.follow(walker, 0.75, 0.025, hall(), {});
    EXPECT_TRUE(hall().map().at(walker.map_from_person().position()) == CellState::Free);
  }
  EXPECT_TRUE(route.finished());
  EXPECT_LT((walker.map_from_person().position() - Eigen::Vector2d(8.5, 3.5)).norm(), 0.2);
}

TEST(Route, LeavesOutACornerThatNobodyCanReach) {
  Walker walker{{2.5, 2.5, 0.0}};
  Route route{{{30.0, 30.0}, {3.5, 2.5}}};
  for (int i = 0; i < 200 && !route.finished(); ++i) route.follow(walker, 0.75, 0.025, hall(), {});
  EXPECT_TRUE(route.finished());
  EXPECT_LT((walker.map_from_person().position() - Eigen::Vector2d(3.5, 2.5)).norm(), 0.2);
}

TEST(Route, EndsEvenIfItsLastCornerIsInAWall) {
  Walker walker{{2.5, 2.5, 0.0}};
  Route route{{{5.5, 2.5}}};
  int steps = 0;
  for (; steps < 40 * 30 && !route.finished(); ++steps) route.follow(walker, 0.75, 0.025, hall(), {});
  EXPECT_TRUE(route.finished());
  EXPECT_GT(hall().clearance_m(walker.map_from_person().position()), 0.1);
}

TEST(Route, EndsEvenIfSomebodyStandsOnItsEnd) {
  const std::vector<Disc> others{{{4.2, 1.5}, 0.4}};
  Walker walker{{1.8, 1.5, 0.0}};
  Route route{{{4.2, 1.5}}};
  for (int i = 0; i < 40 * 30 && !route.finished(); ++i) route.follow(walker, 0.75, 0.025, hall(), others);
  EXPECT_TRUE(route.finished());
}

TEST(PasserBy, StaysOnFreeGroundAndGetsAbout) {
  const Place place = hall();
  const auto ground = place.largest_ground(0.45);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PasserBy passer_by{ground, Rng{seed}};
    const Eigen::Vector2d start = passer_by.walker().map_from_person().position();
    double farthest = 0.0;
    for (int i = 0; i < 40 * 60; ++i) {
      passer_by.step(0.025, place, ground, {});
      const Eigen::Vector2d here = passer_by.walker().map_from_person().position();
      ASSERT_GT(place.clearance_m(here), 0.1) << "seed " << seed;
      farthest = std::max(farthest, (here - start).norm());
    }
    EXPECT_GT(farthest, 2.0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tandem::simulator
