#pragma once

#include "services/simulator/core/my_pose_habit.hpp"
#include "services/simulator/core/phone_user.hpp"

namespace tandem::simulator {

/// How an obedient person is.
struct ObedientHabits {
  double latency_min_s = 3.0;  ///< From a new plan on the phone to walking it.
  double latency_max_s = 8.0;
  MyPoseHabit my_pose;
  double detection_rate_per_s = 0.5;  ///< Of a token that can be seen.
  double patience_s = 4.0;            ///< Stands so long without a plan before pressing *Replan*.
  double replan_interval_s = 15.0;    ///< Never presses *Replan* more often than this.
  double retry_s = 3.0;               ///< After a *Replan* that was refused.
};

/// Does as the plan says, after a moment; says where they are; asks for a plan when there is nothing to do.
class ObedientPerson final : public PhoneUser {
 public:
  explicit ObedientPerson(const ObedientHabits& habits = {}) : habits_(habits), my_pose_(habits.my_pose) {}
  [[nodiscard]] PhoneUserDecision step(const PhoneUserInput& input, Rng& rng) override;

 private:
  void react_to_plan(const PhoneUserInput& input, Rng& rng, PhoneUserDecision& decision);
  void ask_for_plan(const PhoneUserInput& input, PhoneUserDecision& decision);

  ObedientHabits habits_;
  MyPoseButton my_pose_;
  bool greeted_ = false;  ///< The first *My pose* and *Replan* are out.
  bool found_ = false;
  std::string noticed_plan_;  ///< The newest plan that was noticed.
  std::string walked_plan_;   ///< The plan being walked.
  Time walks_at_{};           ///< When the noticed plan will be walked.
  Time last_replan_{};
  Time idle_since_{};
};

}  // namespace tandem::simulator
