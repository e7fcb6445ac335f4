#include "services/tracking/core/teammate.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem::tracking {
namespace {

const TrackingConfig kConfig;
using Places = std::vector<Eigen::Vector2d>;

Time at(double time_s) {
  return from_stamp_ns(0) + from_seconds(1000.0 + time_s);
}

/// People who stand or walk, seen ten times a second.
class Scene {
 public:
  /// Lets time pass to `until_s` with somebody at each of the places `people(t)` gives.
  template <typename People>
  void run(double until_s, People people) {
    for (; next_s_ < until_s + 1e-9; next_s_ += 0.1) {
      std::vector<Sighting> seen;
      for (const Eigen::Vector2d& person : people(next_s_)) seen.push_back({person, 0.08, true});
      tracker.update(at(next_s_), seen);
      teammate.see(at(next_s_), tracker);
    }
  }
  [[nodiscard]] TeammateEstimate now() const { return teammate.estimate(at(next_s_ - 0.1)).value(); }

  PeopleTracker tracker{kConfig};
  Teammate teammate{kConfig};

 private:
  double next_s_ = 0.0;
};

Places nobody(double) {
  return {};
}

TEST(Teammate, NobodyIsTheTeammateBeforeAMessage) {
  Scene scene;
  scene.run(1.0, [](double) { return Places{{2.0, 0.0}}; });
  EXPECT_FALSE(scene.teammate.estimate(at(1.0)));
}

TEST(Teammate, AMessageNamesTheNearestTrack) {
  Scene scene;
  const auto two = [](double) { return Places{{2.0, 0.0}, {5.0, 0.0}}; };
  scene.run(1.0, two);
  scene.teammate.hear({at(1.0), {4.2, 0.5}, {}}, scene.tracker);
  scene.run(1.5, two);
  EXPECT_NEAR(scene.now().map_from_agent.x, 5.0, 0.05);
  EXPECT_EQ(scene.now().source, Source::Laser);
  EXPECT_FALSE(scene.now().lost);
}

TEST(Teammate, WhereTheLaserSeesNobodyTheMessageIsAllThereIs) {
  Scene scene;
  scene.run(1.0, nobody);
  scene.teammate.hear({at(1.0), {4.0, 3.0}, 1.5}, scene.tracker);
  const TeammateEstimate estimate = scene.now();
  EXPECT_EQ(estimate.source, Source::Message);
  EXPECT_DOUBLE_EQ(estimate.map_from_agent.x, 4.0);
  EXPECT_DOUBLE_EQ(estimate.map_from_agent.heading, 1.5);
  EXPECT_NEAR(estimate.standard_deviation_m, kConfig.message_deviation_m, 1e-6);
}

TEST(Teammate, IsLostAfterTenSecondsWithoutAnySign) {
  Scene scene;
  scene.run(1.0, nobody);
  scene.teammate.hear({at(1.0), {4.0, 3.0}, {}}, scene.tracker);
  EXPECT_FALSE(scene.teammate.estimate(at(11.0))->lost);
  EXPECT_TRUE(scene.teammate.estimate(at(11.1))->lost);
  EXPECT_EQ(scene.teammate.estimate(at(5.0))->source, Source::Predicted);
  EXPECT_NEAR(scene.teammate.estimate(at(5.0))->age_s, 4.0, 1e-9);
}

TEST(Teammate, LegsAreMoreExactThanFingers) {
  Scene scene;
  const auto walker = [](double time_s) { return Places{{0.7 * time_s, 0.0}, {3.5, 1.5}}; };
  scene.run(1.0, walker);
  scene.teammate.hear({at(1.0), {0.6, 0.0}, {}}, scene.tracker);
  scene.run(5.0, walker);
  scene.teammate.hear({at(5.0), {3.5, 1.0}, {}}, scene.tracker);  // nearer to the passer-by, but not far off
  scene.run(6.0, walker);
  EXPECT_NEAR(scene.now().map_from_agent.x, 4.2, 0.1);
  EXPECT_NEAR(scene.now().velocity_in_map_mps.x(), 0.7, 0.1);
}

TEST(Teammate, AMessageFarFromTheTrackNamesSomebodyElse) {
  Scene scene;
  const auto two = [](double) { return Places{{2.0, 0.0}, {8.0, 0.0}}; };
  scene.run(1.0, two);
  scene.teammate.hear({at(1.0), {2.0, 0.0}, {}}, scene.tracker);
  scene.run(2.0, two);
  scene.teammate.hear({at(2.0), {7.5, 0.0}, {}}, scene.tracker);
  scene.run(2.5, two);
  EXPECT_NEAR(scene.now().map_from_agent.x, 8.0, 0.05);
}

TEST(Teammate, AMessageThatFitsAnotherMuchBetterNamesThem) {
  Scene scene;
  const auto two = [](double) { return Places{{2.0, 0.0}, {4.0, 0.0}}; };
  scene.run(1.0, two);
  scene.teammate.hear({at(1.0), {2.0, 0.0}, {}}, scene.tracker);
  scene.run(2.0, two);
  scene.teammate.hear({at(2.0), {3.9, 0.0}, {}}, scene.tracker);  // 1.9 m off the one, 0.1 m off the other
  scene.run(2.5, two);
  EXPECT_NEAR(scene.now().map_from_agent.x, 4.0, 0.05);
}

TEST(Teammate, OfTwoNewOnesTheMuchLikelierIsTaken) {
  Scene scene;
  scene.run(1.0, nobody);
  scene.teammate.hear({at(1.0), {0.0, 0.0}, {}}, scene.tracker);
  scene.run(3.0, [](double) { return Places{{0.0, 0.2}, {0.0, -2.2}}; });
  ASSERT_TRUE(scene.teammate.track_id());
  EXPECT_NEAR(scene.now().map_from_agent.y, 0.2, 0.05);
}

TEST(Teammate, WhereSomebodyHasJustSaidTheyStandOneLegIsEnough) {
  Scene scene;
  scene.teammate.hear({at(0.0), {1.0, 0.0}, {}}, scene.tracker);
  for (int i = 1; i <= 5; ++i) {
    scene.tracker.update(at(0.1 * i), {{{1.1, 0.0}, 0.16, false}});
    scene.teammate.see(at(0.1 * i), scene.tracker);
  }
  EXPECT_TRUE(scene.teammate.track_id());
}

TEST(Teammate, IsFoundAgainWhenComingOutFromBehindAWall) {
  Scene scene;
  const auto walker = [](double time_s) {
    return time_s > 3.0 && time_s < 6.0 ? Places{} : Places{{0.5 * time_s, 0.0}};
  };
  scene.run(1.0, walker);
  scene.teammate.hear({at(1.0), {0.5, 0.0}, {}}, scene.tracker);
  scene.run(5.5, walker);
  EXPECT_EQ(scene.now().source, Source::Predicted);
  EXPECT_FALSE(scene.teammate.track_id());
  scene.run(7.0, walker);
  EXPECT_EQ(scene.now().source, Source::Laser);
  EXPECT_NEAR(scene.now().map_from_agent.x, 3.5, 0.1);
}

TEST(Teammate, IsNotTakenForOneOfTwoStrangers) {
  Scene scene;
  scene.run(1.0, nobody);
  scene.teammate.hear({at(1.0), {0.0, 0.0}, {}}, scene.tracker);
  scene.run(3.0, [](double) { return Places{{0.0, 1.0}, {0.0, -1.0}}; });
  EXPECT_FALSE(scene.teammate.track_id());
}

TEST(Teammate, IsNotTakenForAPasserByWhoWasThereAllAlong) {
  Scene scene;
  const auto both = [](double time_s) {
    Places places = {{0.0, 6.0 - 0.8 * time_s}};     // walks past
    if (time_s < 4.0) places.push_back({1.5, 1.0});  // stands, then steps behind a wall
    return places;
  };
  scene.run(1.0, both);
  scene.teammate.hear({at(1.0), {1.5, 1.0}, {}}, scene.tracker);
  scene.run(7.0, both);
  EXPECT_FALSE(scene.teammate.track_id());
  EXPECT_NEAR(scene.now().map_from_agent.y, 1.0, 0.1);
}

TEST(Teammate, IsThoughtToWalkAsThePlanSays) {
  Scene scene;
  scene.run(1.0, nobody);
  scene.teammate.follow({{0.0, 0.0}, {3.0, 0.0}, {3.0, 9.0}});
  scene.teammate.hear({at(1.0), {0.0, 0.5}, {}}, scene.tracker);
  const TeammateEstimate estimate = scene.teammate.estimate(at(9.0)).value();  // 8 s at 0.75 m/s: 3 m and 3 m
  EXPECT_NEAR(estimate.map_from_agent.x, 3.0, 1e-9);
  EXPECT_NEAR(estimate.map_from_agent.y, 3.5, 1e-9);
  EXPECT_NEAR(estimate.map_from_agent.heading, std::numbers::pi / 2.0, 1e-9);
  EXPECT_GE(estimate.standard_deviation_m, 4.0);  // 8 s at 0.5 m/s
}

TEST(Teammate, WithoutAPlanGoesOnForAMoment) {
  Scene scene;
  scene.run(3.0, [](double time_s) { return Places{{0.6 * time_s, 0.0}}; });
  scene.teammate.hear({at(3.0), {1.8, 0.0}, {}}, scene.tracker);
  const TeammateEstimate estimate = scene.teammate.estimate(at(8.0)).value();
  EXPECT_NEAR(estimate.map_from_agent.x, 1.8 + 0.6 * kConfig.coast_s, 0.15);
}

TEST(Teammate, ALateMessageDoesNotMoveWhomTheLaserHasSeenSince) {
  Scene scene;
  const auto walker = [](double time_s) { return time_s > 2.0 ? Places{} : Places{{0.6 * time_s, 0.0}}; };
  scene.run(1.0, walker);
  scene.teammate.hear({at(1.0), {0.6, 0.0}, {}}, scene.tracker);
  scene.run(4.0, walker);  // out of sight since 2 s
  scene.teammate.hear({at(1.5), {0.0, 3.0}, {}}, scene.tracker);
  EXPECT_LT(scene.now().map_from_agent.y, 0.2);
}

}  // namespace
}  // namespace tandem::tracking
