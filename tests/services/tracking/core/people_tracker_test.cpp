#include "services/tracking/core/people_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/common/random.hpp"

namespace tandem::tracking {
namespace {

const TrackingConfig kConfig;

Time at(double time_s) {
  return from_stamp_ns(0) + from_seconds(1000.0 + time_s);
}

Sighting pair_at(double x, double y) {
  return {{x, y}, 0.08, true};
}

int people_in(const PeopleTracker& tracker) {
  return static_cast<int>(
      std::count_if(tracker.tracks().begin(), tracker.tracks().end(), [](const Track& track) { return track.person; }));
}

TEST(PeopleTracker, BelievesInSomeoneAfterThreeSightings) {
  PeopleTracker tracker{kConfig};
  tracker.update(at(0.0), {pair_at(1.0, 0.0)});
  tracker.update(at(0.1), {pair_at(1.0, 0.0)});
  EXPECT_EQ(people_in(tracker), 0);
  tracker.update(at(0.2), {pair_at(1.0, 0.0)});
  EXPECT_EQ(people_in(tracker), 1);
}

TEST(PeopleTracker, LearnsTheVelocityOfAWalker) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i <= 20; ++i) tracker.update(at(0.1 * i), {pair_at(0.075 * i, 2.0)});  // 0.75 m/s
  ASSERT_EQ(tracker.tracks().size(), 1u);
  const Track& track = tracker.tracks().front();
  EXPECT_NEAR(track.motion.position().x(), 1.5, 0.05);
  EXPECT_NEAR(track.motion.velocity().x(), 0.75, 0.1);
  EXPECT_NEAR(track.motion.velocity().y(), 0.0, 0.05);
}

TEST(PeopleTracker, KeepsTheirNamesWhenTwoWalkPastEachOther) {
  PeopleTracker tracker{kConfig};
  Rng rng{3};
  const auto noisy = [&](double x, double y) { return pair_at(x + rng.normal(0.0, 0.03), y + rng.normal(0.0, 0.03)); };
  for (int i = 0; i <= 60; ++i) {
    const double way = 0.1 * i;  // 1 m/s towards each other, 0.6 m apart when they meet
    tracker.update(at(0.1 * i), {noisy(way, 0.3), noisy(6.0 - way, -0.3)});
  }
  ASSERT_EQ(tracker.tracks().size(), 2u);
  EXPECT_EQ(tracker.tracks()[0].id, 1u);
  EXPECT_NEAR(tracker.tracks()[0].motion.position().x(), 6.0, 0.1);
  EXPECT_NEAR(tracker.tracks()[1].motion.position().x(), 0.0, 0.1);
}

TEST(PeopleTracker, FollowsAWalkerThroughASecondBehindAPillar) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i <= 50; ++i) {
    std::vector<Sighting> seen;
    if (i < 20 || i >= 30) seen.push_back(pair_at(0.08 * i, 0.0));
    tracker.update(at(0.1 * i), seen);
  }
  ASSERT_EQ(tracker.tracks().size(), 1u);
  EXPECT_EQ(tracker.tracks()[0].id, 1u);
}

TEST(PeopleTracker, ForgetsWhoIsGone) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i < 5; ++i) tracker.update(at(0.1 * i), {pair_at(1.0, 0.0)});
  tracker.update(at(1.8), {});
  EXPECT_EQ(people_in(tracker), 1);
  tracker.update(at(2.0), {});
  EXPECT_EQ(people_in(tracker), 0);
}

TEST(PeopleTracker, AThingWithOneLegThatStandsIsNobody) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i < 50; ++i) tracker.update(at(0.1 * i), {{{2.0, 0.0}, 0.16, false}});
  EXPECT_EQ(people_in(tracker), 0);
  EXPECT_TRUE(tracker.tracks().front().confirmed);
}

TEST(PeopleTracker, OneLegThatWalksIsSomebody) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i < 20; ++i) tracker.update(at(0.1 * i), {{{0.06 * i, 0.0}, 0.16, false}});
  EXPECT_EQ(people_in(tracker), 1);
}

TEST(PeopleTracker, ASecondLegIsNotASecondPerson) {
  PeopleTracker tracker{kConfig};
  for (int i = 0; i < 5; ++i) tracker.update(at(0.1 * i), {pair_at(1.0, 0.0)});
  for (int i = 5; i < 15; ++i) {
    tracker.update(at(0.1 * i), {{{1.2, 0.0}, 0.16, false}, {{0.8, 0.0}, 0.16, false}});
  }
  EXPECT_EQ(tracker.tracks().size(), 1u);
}

TEST(PeopleTracker, ASightingMakesAMotionMoreCertainNeverLess) {
  Rng rng{9};
  for (int i = 0; i < 200; ++i) {
    Motion motion;
    motion.covariance = Eigen::Matrix4d::Identity() * rng.uniform(0.01, 2.0);
    motion = predicted(motion, rng.uniform(0.05, 1.0), rng.uniform(0.1, 3.0));
    const Sighting sighting{{rng.normal(), rng.normal()}, rng.uniform(0.05, 0.5), true};
    const Motion after = corrected(motion, sighting);
    EXPECT_LE(after.standard_deviation_m(), motion.standard_deviation_m());
    EXPECT_LE(after.standard_deviation_m(), sighting.standard_deviation_m + 1e-9);
    EXPECT_LE((after.position() - sighting.position_in_map).norm(),
              (motion.position() - sighting.position_in_map).norm() + 1e-9);
  }
}

}  // namespace
}  // namespace tandem::tracking
