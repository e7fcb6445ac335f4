#include "services/planner/core/srs/planar_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "services/common/random.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

const PlanarShape kSquare = Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
const PlanarShape kCorner = Corridor{{{0, 0}, {4, 0}, {4, 4}}, 1.0};

std::vector<double> crossings(const PlanarShape& shape, const Vector2d& from, const Vector2d& to,
                              double level_m = 0.0) {
  std::vector<double> shares;
  EXPECT_TRUE(append_level_crossings(shape, level_m, from, to, shares));
  std::sort(shares.begin(), shares.end());
  const auto same = [](double a, double b) { return b - a < 1e-12; };
  shares.erase(std::unique(shares.begin(), shares.end(), same), shares.end());
  return shares;
}

TEST(PlanarShape, APolygonIsClosed) {
  EXPECT_TRUE(contains(kSquare, {2, 1}));
  EXPECT_DOUBLE_EQ(signed_distance(kSquare, {1, 1}), -1.0);
  EXPECT_DOUBLE_EQ(signed_distance(kSquare, {5, 6}), 5.0);  // 3-4-5 from the corner (2, 2)
  EXPECT_EQ(crossings(kSquare, {-1, 1}, {3, 1}), (std::vector<double>{0.25, 0.75}));
}

TEST(PlanarShape, AHalfPlaneHasNoEnd) {
  const PlanarShape behind = HalfPlane{{0, 0}, {2, 0}};
  EXPECT_DOUBLE_EQ(signed_distance(behind, {-3, 100}), -3.0);
  EXPECT_DOUBLE_EQ(signed_distance(behind, {4, -7}), 4.0);
  EXPECT_EQ(crossings(behind, {-1, 0}, {3, 0}), std::vector<double>{0.25});
  EXPECT_FALSE(enclosing_disc(behind));
}

TEST(PlanarShape, ACorridorHasRoundEndsAndNoEdgesWithin) {
  EXPECT_DOUBLE_EQ(signed_distance(kCorner, {-3, -4}), 4.0);  // 3-4-5 from its start, half width 1
  EXPECT_DOUBLE_EQ(signed_distance(kCorner, {2, 0.25}), -0.75);
  EXPECT_EQ(crossings(kCorner, {-2, 0}, {6, 0}), (std::vector<double>{0.125, 0.875}));  // not at the bend
}

TEST(PlanarShape, TheVectorLeadsFromTheNearestPointOfTheBoundary) {
  EXPECT_EQ(vector_to(kSquare, {3, 1}).direction, Vector2d(1, 0));
  EXPECT_EQ(vector_to(kSquare, {1.5, 1}).direction, Vector2d(-1, 0));  // inwards
  EXPECT_EQ(vector_to(kSquare, {2, 1}).direction, Vector2d(1, 0));     // on it: straight out
  EXPECT_EQ(vector_to(HalfPlane{{0, 0}, {0, 3}}, {5, -2}).direction, Vector2d(0, -1));
}

TEST(PlanarShape, WhereSeveralPointsAreNearestTheSameOneIsAlwaysTaken) {
  EXPECT_EQ(vector_to(Disc{{1, 1}, 2.0}, {1, 1}).direction, Vector2d(-1, 0));  // from the point at +x
  EXPECT_DOUBLE_EQ(vector_to(Disc{{1, 1}, 2.0}, {1, 1}).distance, -2.0);
  EXPECT_EQ(vector_to(kSquare, {1, 1}).direction, Vector2d(0, 1));  // from the first edge, the lower one
}

TEST(PlanarShape, AWayThatOnlyTouchesADiscDoesNotCrossIt) {
  EXPECT_TRUE(crossings(Disc{{0, 1}, 1.0}, {-5, 0}, {5, 0}).empty());
  EXPECT_EQ(crossings(Disc{{0, 0}, 1.0}, {-2, 0}, {2, 0}), (std::vector<double>{0.25, 0.75}));
}

TEST(PlanarShape, CrossingsOfALevelHaveThatDistance) {
  Rng rng{7};
  const HalfPlane half_plane{{0.3, 0.2}, {1, 2}};
  for (const PlanarShape& shape : {PlanarShape{Disc{{1, 1}, 2.0}}, kCorner, PlanarShape{half_plane}, kSquare}) {
    for (int i = 0; i < 200; ++i) {
      const Vector2d from{rng.uniform(-6, 6), rng.uniform(-6, 6)};
      const Vector2d to{rng.uniform(-6, 6), rng.uniform(-6, 6)};
      const double level_m = std::holds_alternative<Polygon>(shape) ? 0.0 : rng.uniform(-0.9, 2.0);
      const auto shares = crossings(shape, from, to, level_m);
      for (const double share : shares) {
        EXPECT_NEAR(signed_distance(shape, from + share * (to - from)), level_m, 1e-9) << i;
      }
      const bool changes = (signed_distance(shape, from) > level_m) != (signed_distance(shape, to) > level_m);
      EXPECT_TRUE(!changes || !shares.empty()) << i;
    }
  }
}

TEST(PlanarShape, MovingShapeAndPointTogetherKeepsTheDistance) {
  const Vector2d origin{3, -1};
  const double quarter = std::numbers::pi / 2;
  for (const PlanarShape& shape : {PlanarShape{Disc{{1, 1}, 2.0}}, kCorner, kSquare}) {
    EXPECT_NEAR(signed_distance(moved(shape, origin, quarter), {3 - 5, -1 + 6}), signed_distance(shape, {6, 5}), 1e-12);
  }
}

TEST(PlanarShape, AnInnerPointIsInsideEvenOfAnAngle) {
  const PlanarShape angle = Polygon{{{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 6}, {0, 6}}};
  for (const PlanarShape& shape : {angle, kCorner, kSquare, PlanarShape{HalfPlane{{5, 5}, {1, 1}}}}) {
    EXPECT_LT(signed_distance(shape, inner_point(shape)), -0.4);
  }
}

TEST(PlanarShape, DegenerateShapesAreNamed) {
  EXPECT_FALSE(problem_of(kSquare));
  EXPECT_FALSE(problem_of(kCorner));
  EXPECT_TRUE(problem_of(Disc{{0, 0}, 0.0}));
  EXPECT_TRUE(problem_of(Polygon{{{0, 0}, {1, 0}}}));
  EXPECT_TRUE(problem_of(Polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}));  // a bow tie
  EXPECT_TRUE(problem_of(Polygon{{{0, 0}, {1, 0}, {2, 0}}}));          // flat
  EXPECT_TRUE(problem_of(Corridor{{{1, 1}, {1, 1}}, 1.0}));
  EXPECT_TRUE(problem_of(Corridor{{{1, 1}, {2, 1}}, 0.0}));
  EXPECT_TRUE(problem_of(HalfPlane{{0, 0}, {0, 0}}));
}

}  // namespace
}  // namespace tandem
