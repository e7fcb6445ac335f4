#include "services/experiment/core/humans/next_place.hpp"

#include <gtest/gtest.h>

#include "tests/services/experiment/core/humans/hall.hpp"

namespace tandem::experiment {
namespace {

/// Goes from place to place, looking around at each; returns the share of the floor seen.
double share_seen_after(NextPlace& chooser, Hall& hall, int stops) {
  OwnMemory memory(hall.world);
  Rng rng{7};
  Eigen::Vector2d here{2.0, 2.0};
  for (int i = 0; i < stops; ++i) {
    memory.look(hall.world, here);
    const auto cell = chooser.choose(*hall.world.ways_from(here), hall.world, memory, rng);
    if (!cell) break;
    here = hall.world.area().point(*cell);
  }
  int seen = 0;
  for (int cell = 0; cell < hall.world.area().size(); ++cell) seen += memory.has_seen(cell) ? 1 : 0;
  return static_cast<double>(seen) / hall.world.area().size();
}

TEST(GreedyPlace, SeesAHallWithFewStops) {
  Hall hall;
  // 160 m2 and at most 28 m2 a stop: six stops at best.
  EXPECT_GT(share_seen_after(*greedy_place(1.5), hall, 25), 0.97);
}

TEST(GreedyPlace, GoesAnywhereOnceAllIsSeen) {
  Hall hall(4, 4);
  OwnMemory memory(hall.world);
  memory.look(hall.world, {1.5, 1.5});
  memory.look(hall.world, {3.5, 3.5});
  memory.look(hall.world, {1.5, 3.5});
  memory.look(hall.world, {3.5, 1.5});
  Rng rng{1};
  EXPECT_TRUE(greedy_place(1.5)->choose(*hall.world.ways_from({2.0, 2.0}), hall.world, memory, rng));
}

TEST(LawnmowerPlace, SeesAHallLaneByLane) {
  Hall hall;
  // 16 m x 10 m in lanes of 4 m: three lanes of four stops.
  EXPECT_EQ(lawnmower_stops(hall.world.area(), 4.0).size(), 12U);
  EXPECT_GT(share_seen_after(*lawnmower_place(4.0), hall, 13), 0.85);
}

TEST(LawnmowerPlace, EverySecondLaneGoesBackAndTheWholeBeginsAgain) {
  Hall hall;
  const auto& area = hall.world.area();
  const auto stops = lawnmower_stops(area, 4.0);
  EXPECT_LT(area.point(stops[0]).x(), area.point(stops[1]).x());
  EXPECT_GT(area.point(stops[4]).x(), area.point(stops[5]).x());

  OwnMemory memory(hall.world);
  Rng rng{1};
  const auto lawnmower = lawnmower_place(4.0);
  std::optional<int> last;
  for (std::size_t i = 0; i < stops.size(); ++i)
    last = lawnmower->choose(*hall.world.ways_from({2.0, 2.0}), hall.world, memory, rng);
  EXPECT_EQ(last, stops.back());
  EXPECT_EQ(lawnmower->choose(*hall.world.ways_from({2.0, 2.0}), hall.world, memory, rng),
            stops.back());  // and back again
}

TEST(LawnmowerPlace, BeginsAtItsNearerEnd) {
  Hall hall;
  OwnMemory memory(hall.world);
  Rng rng{1};
  const auto stops = lawnmower_stops(hall.world.area(), 4.0);
  EXPECT_EQ(lawnmower_place(4.0)->choose(*hall.world.ways_from(hall.world.area().point(stops.back())), hall.world,
                                         memory, rng),
            stops.back());
}

TEST(RandomPlace, EqualSeedsChooseEqualPlaces) {
  Hall hall;
  OwnMemory memory(hall.world);
  Rng one{3};
  Rng other{3};
  const auto chooser = random_place();
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(chooser->choose(*hall.world.ways_from({2.0, 2.0}), hall.world, memory, one),
              chooser->choose(*hall.world.ways_from({2.0, 2.0}), hall.world, memory, other));
  }
}

}  // namespace
}  // namespace tandem::experiment
