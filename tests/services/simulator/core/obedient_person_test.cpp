#include "services/simulator/core/obedient_person.hpp"

#include <gtest/gtest.h>

namespace tandem::simulator {
namespace {

/// A person at their phone; time goes in steps of 0.1 s.
struct Person {
  ObedientPerson mind;
  Rng rng{5};
  PhoneUserInput input{.dt_s = 0.1, .connected = true};
  std::vector<std::pair<double, PhoneMessage>> pressed;  ///< when [s], what
  std::optional<double> walked_at_s;
  double time_s = 0.0;

  PhoneUserDecision step() {
    input.now = Time{} + from_seconds(time_s);
    auto decision = mind.step(input, rng);
    for (const auto& message : decision.messages) pressed.emplace_back(time_s, message);
    if (decision.new_route_in_map && !decision.new_route_in_map->empty()) {
      walked_at_s = time_s;
      input.walking = true;
    }
    time_s += input.dt_s;
    return decision;
  }
  void run(double seconds) {
    for (const double end = time_s + seconds; time_s < end;) (void)step();
  }
  [[nodiscard]] std::vector<double> times_of(PhonePress press) const {
    std::vector<double> times;
    for (const auto& [at, message] : pressed) {
      if (message.press == press) times.push_back(at);
    }
    return times;
  }
};

TEST(ObedientPerson, BeginsWithMyPoseAndReplanOnceThePhoneIsConnected) {
  Person person;
  person.input.connected = false;
  person.run(2.0);
  EXPECT_TRUE(person.pressed.empty());
  person.input.connected = true;
  (void)person.step();
  ASSERT_EQ(person.pressed.size(), 2U);
  EXPECT_EQ(person.pressed[0].second.press, PhonePress::MyPose);
  EXPECT_EQ(person.pressed[1].second.press, PhonePress::Replan);
}

TEST(ObedientPerson, WalksANewPlanAfterThreeToEightSeconds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Person person;
    person.rng = Rng{seed};
    person.run(1.0);
    person.input.plan = PhonePlan{"a", {{0.0, 0.0}, {5.0, 0.0}}};
    person.run(9.0);
    ASSERT_TRUE(person.walked_at_s) << "seed " << seed;
    EXPECT_GE(*person.walked_at_s, 3.9) << "seed " << seed;
    EXPECT_LE(*person.walked_at_s, 9.2) << "seed " << seed;
  }
}

TEST(ObedientPerson, DoesNotWalkBackToTheBeginningOfAPlan) {
  Person person;
  person.input.map_from_person = {2.1, 0.0, 0.0};
  person.input.plan = PhonePlan{"a", {{0.0, 0.0}, {2.0, 0.0}, {4.0, 0.0}}};
  std::optional<std::vector<Eigen::Vector2d>> route;
  for (int i = 0; i < 100 && !route; ++i) route = person.step().new_route_in_map;
  ASSERT_TRUE(route);
  ASSERT_EQ(route->size(), 1U);
  EXPECT_EQ(route->front(), Eigen::Vector2d(4.0, 0.0));
}

TEST(ObedientPerson, SaysWhereTheyAreAboutEveryEightSecondsAboutRight) {
  Person person;
  person.input.map_from_person = {3.0, 4.0, 1.0};
  person.input.walking = true;
  person.run(800.0);
  const auto times = person.times_of(PhonePress::MyPose);
  EXPECT_GT(times.size(), 85U);
  EXPECT_LT(times.size(), 115U);
  double squares = 0.0;
  int poses = 0;
  for (const auto& [at, message] : person.pressed) {
    if (message.press != PhonePress::MyPose) continue;
    squares += (*message.point_in_map - Eigen::Vector2d{3.0, 4.0}).squaredNorm();
    ++poses;
    EXPECT_EQ(message.heading, 1.0);
  }
  EXPECT_NEAR(std::sqrt(squares / poses), 0.3, 0.06);
}

TEST(ObedientPerson, AsksForAPlanWhenTheLastIsWalkedAndNoneCame) {
  Person person;
  person.input.walking = true;
  person.run(30.0);
  EXPECT_EQ(person.times_of(PhonePress::Replan).size(), 1U);
  person.input.walking = false;
  person.run(5.0);
  EXPECT_EQ(person.times_of(PhonePress::Replan).size(), 2U);
  person.run(5.0);
  EXPECT_EQ(person.times_of(PhonePress::Replan).size(), 2U);  // not again at once
}

TEST(ObedientPerson, AsksAgainSoonWhenTheReplanWasRefused) {
  Person person;
  person.input.replan_refused = true;  // the search has not begun
  person.run(10.0);
  EXPECT_EQ(person.times_of(PhonePress::Replan).size(), 4U);  // at 0, 3, 6 and 9 s
}

TEST(ObedientPerson, DoesNotAskWhileAPlanIsBeingComputed) {
  Person person;
  person.input.computing = true;
  person.run(60.0);
  EXPECT_EQ(person.times_of(PhonePress::Replan).size(), 1U);
}

TEST(ObedientPerson, SeesATokenAtTheRateOfOneInTwoSeconds) {
  double sum_s = 0.0;
  constexpr int kPeople = 400;
  for (std::uint64_t seed = 1; seed <= kPeople; ++seed) {
    Person person;
    person.rng = Rng{seed};
    person.input.visible_token_in_map = Eigen::Vector2d{1.0, 2.0};
    while (person.times_of(PhonePress::Found).empty()) (void)person.step();
    sum_s += person.time_s;
    EXPECT_EQ(person.pressed.back().second.point_in_map, Eigen::Vector2d(1.0, 2.0));
  }
  EXPECT_NEAR(sum_s / kPeople, 2.0, 0.25);
}

TEST(ObedientPerson, StandsAndSaysNothingOnceItIsFound) {
  Person person;
  person.run(1.0);
  person.pressed.clear();
  person.input.search_over = true;
  const auto decision = person.step();
  ASSERT_TRUE(decision.new_route_in_map);
  EXPECT_TRUE(decision.new_route_in_map->empty());
  person.run(60.0);
  EXPECT_TRUE(person.pressed.empty());
}

}  // namespace
}  // namespace tandem::simulator
