#include "services/simulator/core/my_pose_habit.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tandem::simulator {
namespace {

/// When the button is pressed in 3000 s [s], asked every 0.1 s.
std::vector<double> presses(const MyPoseHabit& habit) {
  MyPoseButton button(habit);
  Rng rng{3};
  PhoneUserInput input;
  std::vector<double> times_s;
  for (int i = 0; i < 30000; ++i) {
    input.now = Time{} + from_seconds(0.1 * i);
    if (button.pressed(input, rng)) times_s.push_back(0.1 * i);
  }
  return times_s;
}

TEST(MyPoseHabit, TheFirstPressIsAtOnceAndTheOthersAsFarApartAsTheHabitSays) {
  const auto times_s = presses({});
  ASSERT_GT(times_s.size(), 2U);
  EXPECT_EQ(times_s.front(), 0.0);
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    EXPECT_GE(times_s[i] - times_s[i - 1], 5.99);
    EXPECT_LE(times_s[i] - times_s[i - 1], 10.11);
  }
}

TEST(MyPoseHabit, VolunteersPressSixAndAHalfTimesAMinuteAndForgetOneInFour) {
  const auto times_s = presses(habit_of_volunteers());
  EXPECT_NEAR(static_cast<double>(times_s.size()), 320.0, 25.0);  // 50 minutes at 6.4 a minute
  int in_time = 0;
  for (std::size_t i = 1; i < times_s.size(); ++i) in_time += times_s[i] - times_s[i - 1] <= 10.05 ? 1 : 0;
  EXPECT_NEAR(in_time / static_cast<double>(times_s.size() - 1), 0.73, 0.07);
}

TEST(MyPoseHabit, SaysWhereThePersonIsAndLooks) {
  MyPoseButton button({.error_m = 0.0});
  Rng rng{3};
  PhoneUserInput input;
  input.map_from_person = {3.0, 4.0, 1.0};
  const auto message = button.pressed(input, rng);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->press, PhonePress::MyPose);
  EXPECT_EQ(message->point_in_map, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(message->heading, 1.0);
}

}  // namespace
}  // namespace tandem::simulator
