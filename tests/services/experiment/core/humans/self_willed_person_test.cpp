#include "services/experiment/core/humans/self_willed_person.hpp"

#include <gtest/gtest.h>

#include "tests/services/experiment/core/humans/hall.hpp"

namespace tandem::experiment {
namespace {

using simulator::PhonePress;

/// A self-willed person at their phone, in steps of 0.1 s.
struct Person {
  explicit Person(const SelfWilledHabits& habits) : mind(habits, hall.world, greedy_place(1.5)) {}

  simulator::PhoneUserDecision step() {
    input.now = Time{} + from_seconds(time_s);
    auto decision = mind.step(input, rng);
    for (const auto& message : decision.messages) pressed.emplace_back(time_s, message.press);
    if (decision.new_route_in_map && !route) {
      route = decision.new_route_in_map;
      walked_at_s = time_s;
      input.walking = !route->empty();
    }
    time_s += input.dt_s;
    return decision;
  }
  void run(double seconds) {
    for (const double end = time_s + seconds; time_s < end - 1e-9;) (void)step();
  }
  [[nodiscard]] int count(PhonePress press) const {
    int count = 0;
    for (const auto& [at_s, what] : pressed) count += what == press ? 1 : 0;
    return count;
  }

  Hall hall;
  SelfWilledPerson mind;
  Rng rng{11};
  simulator::PhoneUserInput input{.dt_s = 0.1, .map_from_person = {2.0, 2.0, 0.0}, .connected = true};
  std::vector<std::pair<double, PhonePress>> pressed;
  std::optional<std::vector<Eigen::Vector2d>> route;
  double walked_at_s = 0.0;
  double time_s = 0.0;
};

TEST(SelfWilledPerson, WalksAfterAThoughtWithoutAnyPlanAndNeverAsksForOne) {
  Person person({});
  person.run(3.0);
  ASSERT_TRUE(person.route);
  EXPECT_NEAR(person.walked_at_s, 1.0, 0.11);
  EXPECT_EQ(person.count(PhonePress::Replan), 0);
  EXPECT_EQ(person.count(PhonePress::MyGoal), 0);
}

TEST(SelfWilledPerson, PressesMyPoseAsOftenAsVolunteersDid) {
  Person person({});
  person.run(1.0);
  person.input.walking = true;
  person.run(3000.0);  // 50 minutes at 6.4 a minute
  EXPECT_NEAR(person.count(PhonePress::MyPose), 320.0, 25.0);
  int in_time = 0;
  double last_s = -1.0;
  for (const auto& [at_s, what] : person.pressed) {
    if (last_s >= 0.0 && at_s - last_s <= 10.05) ++in_time;
    last_s = at_s;
  }
  EXPECT_NEAR(in_time / static_cast<double>(person.count(PhonePress::MyPose) - 1), 0.73, 0.07);
}

TEST(SelfWilledPerson, AnnouncesAGoalAndGoesThereOnceThereIsANewPlan) {
  Person person({.announces = true});
  person.input.plan = simulator::PhonePlan{"a", {{2.0, 2.0}, {3.0, 2.0}}};
  person.run(2.0);
  EXPECT_EQ(person.count(PhonePress::MyGoal), 1);
  EXPECT_EQ(person.count(PhonePress::Replan), 1);
  EXPECT_FALSE(person.route);  // the plan on the phone knows nothing of it
  person.input.plan = simulator::PhonePlan{"b", {{2.0, 2.0}, {3.0, 2.0}}};
  person.run(0.2);
  ASSERT_TRUE(person.route);
  EXPECT_FALSE(person.route->empty());
}

TEST(SelfWilledPerson, DoesNotWaitForeverForANewPlan) {
  Person person({.announces = true});
  person.run(1.0 + 6.0 + 0.3);
  EXPECT_TRUE(person.route);
}

TEST(SelfWilledPerson, StandsOnceTheSearchIsOver) {
  Person person({});
  person.input.search_over = true;
  const auto decision = person.step();
  ASSERT_TRUE(decision.new_route_in_map);
  EXPECT_TRUE(decision.new_route_in_map->empty());
}

}  // namespace
}  // namespace tandem::experiment
