#include "services/planner/core/srs/boundary.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Boundary, TheSearchSpaceFollowsFromTheBoundary) {
  EXPECT_EQ(search_space_of(Nowhere{}), SearchSpace::None);
  EXPECT_EQ(search_space_of(Disc{{0, 0}, 1.0}), SearchSpace::Plane);
  EXPECT_EQ(search_space_of(Between{}), SearchSpace::Plane);
  EXPECT_EQ(search_space_of(SpeedInterval{0.0, 1.0}), SearchSpace::Speed);
  EXPECT_EQ(search_space_of(Box{}), SearchSpace::Volume);
}

TEST(Boundary, OnlyWhatLiesStillHasAShapeOnTheMap) {
  const Polygon kitchen{{{0, 0}, {1, 0}, {1, 1}}};
  EXPECT_EQ(shape_in_map(NamedArea{"kitchen", kitchen}), PlanarShape{kitchen});
  EXPECT_FALSE(shape_in_map(Attached{"person", Disc{{0, 0}, 1.0}}));
}

TEST(Boundary, DegenerateBoundariesAreNamed) {
  EXPECT_TRUE(problem_of(Between{Anchor{.agent = "a"}, Anchor{.agent = "a"}, 1.0}));
  EXPECT_FALSE(problem_of(Between{Anchor{.agent = "a"}, Anchor{.agent = "", .point_in_map = {0, 0}}, 1.0}));
  EXPECT_TRUE(problem_of(SpeedInterval{1.0, 1.0}));
  EXPECT_TRUE(problem_of(Sphere{{0, 0, 0}, 0.0}));
  EXPECT_TRUE(problem_of(Box{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_TRUE(problem_of(Attached{"a", Disc{{0, 0}, 0.0}}));
}

}  // namespace
}  // namespace tandem
