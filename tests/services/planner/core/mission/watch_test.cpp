#include "services/planner/core/mission/watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using std::chrono::milliseconds;

/// A room of 4 m x 4 m, watched from its middle to all sides by one who detects at 1 per s.
struct WatchedRoom {
  OccupancyGrid map = empty_room(4, 4);
  SearchArea area{map, {.start_in_map = {2.5, 2.5}, .outline_in_map = {}}};
  Observability observability{map, area, 10.0};
  SearchBelief belief{uniform_prior(area, {2.5, 2.5}, 0.0)};
  Watch watch{0, Searcher{.id = "person", .view_max_m = 10.0, .detection_rate_per_s = 1.0}};

  void look_at(milliseconds time) { watch.look(Time{} + time, {2.5, 2.5, 0.0}, observability, belief); }
};

TEST(Watch, CreditsTheTimeBetweenTwoLooks) {
  WatchedRoom room;
  room.look_at(milliseconds{0});
  EXPECT_DOUBLE_EQ(room.belief.probability_left(), 1.0);  // one look alone has no length
  room.look_at(milliseconds{500});
  EXPECT_NEAR(room.belief.probability_left(), std::exp(-0.5), 1e-9);
}

TEST(Watch, ALongGapCountsAsOneSecondOnly) {
  WatchedRoom room;
  room.look_at(milliseconds{0});
  room.look_at(milliseconds{30'000});
  EXPECT_NEAR(room.belief.probability_left(), std::exp(-1.0), 1e-9);
}

TEST(Watch, TheTimeOfAPauseIsNoLook) {
  WatchedRoom room;
  room.look_at(milliseconds{0});
  room.watch.pause();
  room.look_at(milliseconds{500});
  EXPECT_DOUBLE_EQ(room.belief.probability_left(), 1.0);
}

TEST(Watch, APoseThatComesLateOrTwiceCountsNothing) {
  WatchedRoom room;
  room.look_at(milliseconds{500});
  room.look_at(milliseconds{500});
  room.look_at(milliseconds{100});
  EXPECT_DOUBLE_EQ(room.belief.probability_left(), 1.0);
}

}  // namespace
}  // namespace tandem
