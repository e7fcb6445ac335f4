#include "services/simulator/core/my_pose_habit.hpp"

#include <numbers>

namespace tandem::simulator {

std::optional<PhoneMessage> MyPoseButton::pressed(const PhoneUserInput& input, Rng& rng) {
  if (next_ && input.now < *next_) return std::nullopt;
  const bool forgets = rng.uniform() < habit_.forgotten_share;
  next_ = input.now + from_seconds(forgets ? rng.uniform(habit_.longest_s, habit_.latest_s)
                                           : rng.uniform(habit_.shortest_s, habit_.longest_s));
  const double each_axis_m = habit_.error_m / std::numbers::sqrt2;
  const Eigen::Vector2d error{rng.normal(0.0, each_axis_m), rng.normal(0.0, each_axis_m)};
  return PhoneMessage{PhonePress::MyPose, input.map_from_person.position() + error, input.map_from_person.heading};
}

}  // namespace tandem::simulator
