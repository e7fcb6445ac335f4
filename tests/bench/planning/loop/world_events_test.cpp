#include "bench/planning/loop/world_events.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(WorldEvents, AHintMakesItsPlaceLikelierAndKeepsTheSum) {
  const OccupancyGrid map = drawn({4.0, 1.0, 0.1, {}}, 0.0);
  const SearchArea area(map, {1.0, 0.25, {0.5, 0.5}, {}});
  std::vector<double> mass(4, 0.2);  // 0.8 in all
  take_hint(mass, area, {WorldEvent::Kind::Hint, 0.0, {0.5, 0.5}, 0.5, 5.0});
  EXPECT_NEAR(mass[0], 0.8 * 5.0 / 8.0, 1e-12);
  EXPECT_NEAR(mass[3], 0.8 / 8.0, 1e-12);
}

}  // namespace
}  // namespace tandem::bench
