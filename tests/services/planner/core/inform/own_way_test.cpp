#include "services/planner/core/inform/own_way.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

/// From 4.75 m one place lies 2 m to the left, the other 5.5 m to the right, seen after 4.9 s at 1 m/s. The
/// robot has searched the left one: it is on the right.
SearchCase searched_on_the_left() {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.0, 10.25, 1.0);
  return search;
}

/// As believed by somebody who does not know that.
std::vector<double> believed(SearchCase& search, double left, double right) {
  std::vector<double> mass(search.problem.masses.front().size(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at(Vector2d{2.75, 1.0}))] = left;
  mass[static_cast<std::size_t>(*search.world().area().cell_at(Vector2d{10.25, 1.0}))] = right;
  return mass;
}

constexpr double kView_s = 0.6;  ///< a place is looked at from up to so far before or behind it

TEST(OwnWay, WhoKnowsGoesThereAtOnceWhoDoesNotLooksElsewhereFirst) {
  SearchCase search = searched_on_the_left();
  EXPECT_NEAR(time_of_own_way_s(search.problem, search.problem.masses.front()), 4.9, kView_s);
  EXPECT_NEAR(time_of_own_way_s(search.problem, believed(search, 0.8, 0.2)), 2.0 + 2.0 + 4.9, 2.0 * kView_s);
}

TEST(OwnWay, KnowingGainsTheWayThereAndBack) {
  SearchCase search = searched_on_the_left();
  EXPECT_NEAR(gain_of_knowing_s(search.problem, believed(search, 0.8, 0.2)), 2.0 + 2.0, 2.0 * kView_s);
}

TEST(OwnWay, KnowingGainsNothingWhereItChangesNoChoice) {
  SearchCase search = searched_on_the_left();
  EXPECT_EQ(gain_of_knowing_s(search.problem, search.problem.masses.front()), 0.0);
  EXPECT_EQ(gain_of_knowing_s(search.problem, believed(search, 0.01, 0.99)), 0.0);  // 0.007 against 0.2 per second
}

TEST(OwnWay, ItGainsLessIfTheRobotGetsThereAnyway) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.0, 10.25, 1.0);
  search.problem.members.pop_back();
  search.problem.others.push_back({1, 0.0, {{{0.0, {4.75, 1.0}}, {5.5, {10.25, 1.0}}}}});  // sees it after 4.9 s
  EXPECT_NEAR(gain_of_knowing_s(search.problem, believed(search, 0.8, 0.2)), 0.0, kView_s);
}

TEST(OwnWay, OnAverageItGainsMoreTheMoreWasSearchedUnseen) {
  SearchCase search(empty_room(24, 16), {2, 2}, {test_person()});
  const SearchArea& area = search.world().area();
  const std::vector<double> even = search.problem.masses.front();
  Rng rng{3};
  const auto somewhere = [&] { return area.point(static_cast<int>(rng.index(static_cast<std::size_t>(area.size())))); };
  double last_s = 0.0;
  for (const double radius_m : {1.0, 3.0, 6.0}) {
    double mean_s = 0.0;
    for (int i = 0; i < 30; ++i) {
      const Vector2d centre = somewhere();
      const Vector2d start = somewhere();
      for (int cell = 0; cell < area.size(); ++cell) {
        const bool is_searched = (area.point(cell) - centre).norm() < radius_m;
        const auto c = static_cast<std::size_t>(cell);
        search.problem.masses.front()[c] = is_searched ? 0.05 * even[c] : even[c];
      }
      search.problem.members.front().pose = {start.x(), start.y(), 0.0};
      mean_s += gain_of_knowing_s(search.problem, even) / 30.0;
    }
    EXPECT_GT(mean_s, last_s) << "radius " << radius_m;
    last_s = mean_s;
  }
}

TEST(OwnWay, AStraightWayThroughAPlaceTakesItsWidthUpToTheFirstWall) {
  const OccupancyGrid map = empty_room(10, 8);  // the wall begins at 10.5 m
  const Disc place{{8.0, 2.0}, 1.0};
  EXPECT_NEAR(time_walked_into_s(map, place, {3.0, 2.0}, {1.0, 0.0}, 0.5, 30.0), 4.0, 0.11);  // 2 m at 0.5 m/s
  EXPECT_NEAR(time_walked_into_s(map, place, {3.0, 2.0}, {1.0, 0.0}, 0.5, 10.0), 2.0, 0.11);  // only up to 8 m
  EXPECT_EQ(time_walked_into_s(map, place, {3.0, 2.0}, {0.0, 1.0}, 0.5, 30.0), 0.0);
  EXPECT_NEAR(time_walked_into_s(map, Disc{{10.5, 2.0}, 1.0}, {3.0, 2.0}, {1.0, 0.0}, 0.5, 30.0), 2.0, 0.11);
}

}  // namespace
}  // namespace tandem
