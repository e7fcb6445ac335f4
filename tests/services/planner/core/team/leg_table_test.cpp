#include "services/planner/core/team/leg_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

Searcher sharp() {
  Searcher person = test_person();
  person.detection_rate_per_s = std::numeric_limits<double>::infinity();
  person.view_max_m = 1.0;
  person.speed_mps = 1.0;
  return person;
}

LegTable table_of(const SearchProblem& problem) {
  const PreparedProblem prepared(problem);
  return leg_table(prepared, near_legs(prepared), problem.masses.front());
}

TEST(LegTable, ARowShowsEachCellOnceAndNoneThatWasFoundOnArrival) {
  SearchCase search(empty_room(8, 6), {3.25, 3.25}, {sharp()}, 0.8);
  const LegTable table = table_of(search.problem);
  ASSERT_FALSE(table.rows.empty());
  for (const LegTable::Row& row : table.rows) {
    std::vector<std::int32_t> cells(table.cells.begin() + static_cast<std::ptrdiff_t>(row.begin),
                                    table.cells.begin() + static_cast<std::ptrdiff_t>(row.end));
    std::ranges::sort(cells);
    EXPECT_EQ(std::ranges::adjacent_find(cells), cells.end());
    if (row.begin_s >= table.capabilities[0].first_s) {
      EXPECT_GT(table.time_s[row.begin], 0.0F);
    }
  }
}

TEST(LegTable, CountsInTheTimeOfTheTeam) {
  Searcher slow = sharp();
  slow.speed_mps = 0.5;
  SearchCase search(empty_room(8, 6), {3.25, 3.25}, {sharp(), slow, slow}, 0.8);
  const LegTable table = table_of(search.problem);
  EXPECT_DOUBLE_EQ(table.capabilities[0].share, 0.5);
  EXPECT_DOUBLE_EQ(table.capabilities[1].share, 0.25);
  EXPECT_EQ(table.capabilities[1].members, (std::vector<std::size_t>{1, 2}));
}

TEST(LegTable, AFirstLegHasNoBudgetBeforeAnythingIsInView) {
  SearchCase search(empty_room(20, 1), {1.75, 1.25}, {sharp()}, 0.8);
  auto& mass = search.problem.masses.front();
  std::ranges::fill(mass, 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at({4.75, 1.25}))] = 1.0;
  const LegTable table = table_of(search.problem);
  const double first_s = table.capabilities[0].first_s;
  EXPECT_NEAR(first_s, 2.0, 0.3);  // seen from the search cell that begins at 3.5 m, or the next
  for (const LegTable::Row& row : table.rows) {
    const double end_s = row.begin_s + row.budget_s;
    EXPECT_GE(end_s, std::min(first_s, row.begin_s));
    if (row.begin < row.end && row.begin_s < first_s) {
      EXPECT_LE(table.time_s[row.begin], row.budget_s);
    }
  }
}

TEST(LegTable, ToTurnIsARowOfItsOwnWhereALookMayMissTheObject) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_robot()});
  const LegTable table = table_of(search.problem);
  EXPECT_TRUE(std::ranges::any_of(table.rows, [](const LegTable::Row& row) { return std::isinf(row.begin_s); }));
  SearchCase all_around(empty_room(8, 6), {3, 3}, {test_person()});
  const LegTable other = table_of(all_around.problem);
  EXPECT_FALSE(std::ranges::any_of(other.rows, [](const LegTable::Row& row) { return std::isinf(row.begin_s); }));
}

}  // namespace
}  // namespace tandem
