#include "services/planner/core/search/sightings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "services/common/random.hpp"
#include "services/planner/core/search/search_objective.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

/// A corridor 10 m long and 0.5 m wide, one row of cells of 0.5 m; x from 0.5 m to 10.5 m.
struct Corridor {
  OccupancyGrid map = room({"######################", "#....................#", "######################"});
  SearchArea area{map, {.walk_clearance_m = 0.1, .start_in_map = {1.0, 0.75}, .outline_in_map = {}}};
  Observability observability{map, area, 1.1};
  Searcher person{.id = "person", .speed_mps = 1.0, .view_max_m = 1.1};
  ViewTable views{observability, person};
  [[nodiscard]] int cell(double x) const { return *area.cell_at({x, 0.75}); }
};

double enter_s(const Sightings& seen, int cell) {
  const auto found = std::ranges::find(seen.cells, cell);
  return found == seen.cells.end() ? -1.0 : seen.enter_s[static_cast<std::size_t>(found - seen.cells.begin())];
}

TEST(Sightings, ACellComesIntoViewWhenTheBorderOfAStandpointIsCrossed) {
  Corridor corridor;
  const TimedPath walk{{{0.0, {0.75, 0.75}}, {6.0, {6.75, 0.75}}}};
  const Sightings seen = sightings_along(walk, 0.0, corridor.views);

  EXPECT_DOUBLE_EQ(enter_s(seen, corridor.cell(0.75)), 0.0);
  EXPECT_DOUBLE_EQ(enter_s(seen, corridor.cell(1.75)), 0.0);    // two cells ahead are in range
  EXPECT_NEAR(enter_s(seen, corridor.cell(2.25)), 0.25, 1e-9);  // the first border is 0.25 m ahead
  EXPECT_NEAR(enter_s(seen, corridor.cell(2.75)), 0.75, 1e-9);
  EXPECT_NEAR(seen.leave_s[0], 1.25, 1e-9);  // the first cell leaves when the third border is crossed
  EXPECT_TRUE(std::is_sorted(seen.enter_s.begin(), seen.enter_s.end()));
}

TEST(Sightings, OnAWayThroughTheCornerOfCellsNobodyLooksFromTheOtherTwo) {
  const OccupancyGrid map = empty_room(8, 8);
  const SearchArea area(map, {.walk_clearance_m = 0.1, .start_in_map = {4.0, 4.0}, .outline_in_map = {}});
  Observability observability(map, area, 1.6);
  Searcher person{.id = "person", .speed_mps = 1.0, .view_max_m = 1.6};
  ViewTable views(observability, person);
  const Eigen::Vector2d corner{4.5, 4.5};
  Rng rng{5};
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d there{rng.uniform(0.05, 0.45), rng.uniform(0.05, 0.45)};
    const Eigen::Vector2d from = corner - there;
    const Eigen::Vector2d to = corner + rng.uniform(0.2, 1.0) * there;
    const Sightings seen = sightings_along({{{0.0, from}, {1.0, to}}}, 0.0, views);
    View expected;
    std::ranges::set_union(views.view(*area.cell_at(from), 0), views.view(*area.cell_at(to), 0),
                           std::back_inserter(expected));
    View cells(seen.cells.begin(), seen.cells.end());
    std::ranges::sort(cells);
    EXPECT_EQ(cells, expected) << i;
  }
}

TEST(Sightings, APathSeenInPiecesShowsTheSameAsInOne) {
  Corridor corridor;
  const TimedPath whole{{{0.0, {0.75, 0.75}}, {9.0, {9.75, 0.75}}}};
  const Sightings all = sightings_along(whole, 0.0, corridor.views);
  SearchObjective objective({uniform_prior(corridor.area, {0, 0}, 0.0)}, 20.0, 20.0);
  const double whole_s = objective.forecast({{{&all, 0.0, 0.7}}}).expected_time_s;

  for (const int pieces : {2, 7, 100}) {
    std::vector<Sightings> parts;
    std::vector<Look> looks;
    for (int i = 0; i < pieces; ++i) {
      const double from_s = 9.0 * i / pieces;
      const double to_s = 9.0 * (i + 1) / pieces;
      parts.push_back(
          sightings_along({{{0.0, {0.75 + from_s, 0.75}}, {to_s - from_s, {0.75 + to_s, 0.75}}}}, 0.0, corridor.views));
    }
    for (int i = 0; i < pieces; ++i) looks.push_back({&parts[static_cast<std::size_t>(i)], 9.0 * i / pieces, 0.7});
    EXPECT_NEAR(objective.forecast(looks).expected_time_s, whole_s, 1e-9) << pieces;
  }
}

TEST(Sightings, DuringAStayOneLooksWhereOneWalked) {
  Corridor corridor;
  Searcher robot = corridor.person;
  robot.field_of_view_rad = 1.0;
  ViewTable views(corridor.observability, robot);
  const TimedPath walk_and_wait{{{0.0, {4.75, 0.75}}, {1.0, {5.75, 0.75}}, {3.0, {5.75, 0.75}}}};
  const Sightings seen = sightings_along(walk_and_wait, 3.14, views);

  EXPECT_GE(enter_s(seen, corridor.cell(6.25)), 0.0);
  EXPECT_EQ(enter_s(seen, corridor.cell(4.25)), -1.0);  // behind
  const auto ahead = std::ranges::find(seen.cells, corridor.cell(6.25)) - seen.cells.begin();
  EXPECT_DOUBLE_EQ(seen.leave_s[static_cast<std::size_t>(ahead)], 3.0);
}

TEST(Sightings, OutsideTheAreaNothingIsSeen) {
  Corridor corridor;
  EXPECT_EQ(sightings_along({{{0.0, {50, 50}}, {5.0, {55, 50}}}}, 0.0, corridor.views).size(), 0U);
}

}  // namespace
}  // namespace tandem
