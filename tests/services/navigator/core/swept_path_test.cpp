#include "services/navigator/core/swept_path.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "services/common/random.hpp"

namespace tandem::navigator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Hull kHull{.length_m = 0.6, .width_m = 0.4};

TEST(SweptPath, MeasuresFromTheHullNotFromTheCentre) {
  EXPECT_DOUBLE_EQ(distance_to(kHull, {1.3, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(distance_to(kHull, {0.0, -0.7}), 0.5);
  EXPECT_DOUBLE_EQ(distance_to(kHull, {0.6, 0.6}), 0.5);  // 0.3 ahead and 0.4 aside of the corner
  EXPECT_DOUBLE_EQ(distance_to(kHull, {0.1, 0.1}), 0.0);
  EXPECT_DOUBLE_EQ((Hull{0.6, 0.8}.circumscribed_radius_m()), 0.5);
}

TEST(SweptPath, StraightAheadOnlyWhatIsInFrontCounts) {
  EXPECT_DOUBLE_EQ(way_to_contact(kHull, 0.0, {1.3, 0.1}), 1.0);
  EXPECT_EQ(way_to_contact(kHull, 0.0, {1.3, 0.21}), kInfinity);
  EXPECT_EQ(way_to_contact(kHull, 0.0, {-0.5, 0.0}), kInfinity);
  EXPECT_DOUBLE_EQ(way_to_contact(kHull, 0.0, {0.2, 0.0}), 0.0);
}

TEST(SweptPath, OnAnArcThePointTurnsAroundItsCentre) {
  // A left turn of radius 1 around (0, 1): a quarter of it brings (1, 1) to where the base is, the front edge earlier.
  const double way = way_to_contact(kHull, 1.0, {1.0, 1.0});
  const double front_touches_after = std::numbers::pi / 2.0 - std::asin(0.3);  // where x = 0.3 on the unit circle
  EXPECT_NEAR(way, front_touches_after, 1e-12);
  EXPECT_NEAR(way_to_contact(kHull, -1.0, {1.0, -1.0}), front_touches_after, 1e-12);  // its mirror image
  EXPECT_EQ(way_to_contact(kHull, 1.0, {0.0, 1.0}), kInfinity);                       // the centre itself
}

TEST(SweptPath, ArcContactAgreesWithSmallSteps) {
  Rng rng{11};
  for (int i = 0; i < 300; ++i) {
    const double curvature = rng.uniform(-2.5, 2.5);
    const Eigen::Vector2d point{rng.uniform(-1.0, 2.0), rng.uniform(-1.5, 1.5)};
    double stepped = kInfinity;
    for (double way = 0.0; way < 3.0; way += 0.002) {
      if (distance_to(kHull, inverse(start_from_end(curvature, way)) * point) <= 0.0) {
        stepped = way;
        break;
      }
    }
    const double exact = way_to_contact(kHull, curvature, point);
    if (stepped < kInfinity) {
      EXPECT_NEAR(exact, stepped, 0.05) << "curvature " << curvature << " point " << point.transpose();
      EXPECT_LE(exact, stepped + 1e-6);
    }
  }
}

TEST(SweptPath, SomethingCloseBesideTheHullDoesNotKeepItFromDrivingAlong) {
  const std::vector<Eigen::Vector2d> beside = {{0.0, 0.23}};  // 3 cm from the hull, within the margin
  EXPECT_EQ(free_way(kHull, 0.05, 0.0, beside).way_m, kInfinity);
  EXPECT_DOUBLE_EQ(free_way(kHull, 0.05, 0.0, {{1.3, 0.23}}).way_m, 0.95);  // ahead, the whole margin counts
}

TEST(SweptPath, SpeedThatStopsWithinIsTheInverseOfTheStoppingDistance) {
  const double speed = speed_that_stops_within(0.5 * 0.5 + 0.25 / 1.2, 0.5, 0.6);  // v t + v^2 / (2 a) at 0.5 m/s
  EXPECT_NEAR(speed, 0.5, 1e-12);
  EXPECT_EQ(speed_that_stops_within(0.0, 0.5, 0.6), 0.0);
  EXPECT_EQ(speed_that_stops_within(-1.0, 0.5, 0.6), 0.0);
}

}  // namespace
}  // namespace tandem::navigator
