#include "services/planner/core/search/view_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

struct Hall {
  OccupancyGrid map = empty_room(10, 10);
  SearchArea area{map, {.start_in_map = {5, 5}, .outline_in_map = {}}};
  Observability observability{map, area, 4.0};
  [[nodiscard]] int cell(double x, double y) const { return *area.cell_at({x, y}); }
};

TEST(ViewTable, WhoSeesAllAroundHasOneSector) {
  Hall hall;
  ViewTable views(hall.observability, {.id = "person", .view_max_m = 4.0});
  EXPECT_EQ(views.sector_of(0.0), views.sector_of(2.0));
  EXPECT_EQ(views.view(hall.cell(5, 5), 0), hall.observability.in_sight_of(hall.cell(5, 5)));
}

TEST(ViewTable, ALimitedViewLiesAheadAndWithinItsRange) {
  Hall hall;
  ViewTable views(hall.observability, {.id = "robot", .view_min_m = 0.6, .view_max_m = 2.0, .field_of_view_rad = 1.0});
  const View& ahead = views.view(hall.cell(5, 5), views.sector_of(0.0));

  EXPECT_TRUE(std::ranges::binary_search(ahead, hall.cell(6.5, 5)));
  EXPECT_FALSE(std::ranges::binary_search(ahead, hall.cell(3.5, 5)));  // behind
  EXPECT_FALSE(std::ranges::binary_search(ahead, hall.cell(8.5, 5)));  // too far
  EXPECT_FALSE(std::ranges::binary_search(ahead, hall.cell(5, 5)));    // too near
}

TEST(ViewTable, HeadingsAllAroundHaveTwentyFourSectors) {
  Hall hall;
  const ViewTable views(hall.observability, {.id = "robot", .field_of_view_rad = 1.0});
  EXPECT_EQ(views.sector_of(3.14159), views.sector_of(-3.14159));
  EXPECT_EQ(views.sector_of(0.1), views.sector_of(-0.1));
  EXPECT_NE(views.sector_of(0.0), views.sector_of(0.27));
}

}  // namespace
}  // namespace tandem
