#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/experiment/core/humans/next_place.hpp"
#include "services/simulator/core/my_pose_habit.hpp"
#include "services/simulator/core/phone_user.hpp"

namespace tandem::experiment {

/// How a person is who goes by their own head.
struct SelfWilledHabits {
  simulator::MyPoseHabit my_pose = simulator::habit_of_volunteers();
  double thought_s = 1.0;   ///< Stands so long before choosing the next place.
  bool announces = false;   ///< Says where they go: *My goal*, then *Replan*, and goes once there is a new plan
  double patience_s = 6.0;  ///< or after this.
};

/// Walks where they think best, whatever is planned; says where they are, by habit, and where they go, if they do.
class SelfWilledPerson final : public simulator::PhoneUser {
 public:
  /// `world` must outlive the person, and may be shared by persons of one thread.
  SelfWilledPerson(const SelfWilledHabits& habits, PersonWorld& world, std::unique_ptr<NextPlace> next_place);

  [[nodiscard]] simulator::PhoneUserDecision step(const simulator::PhoneUserInput& input, Rng& rng) override;

 private:
  /// A walk that was announced and waits for the plan that takes it in.
  struct Announced {
    std::vector<Eigen::Vector2d> way_in_map;
    std::string plan_before;
    Time since{};
  };
  void go_somewhere(const simulator::PhoneUserInput& input, Rng& rng, simulator::PhoneUserDecision& decision);

  SelfWilledHabits habits_;
  PersonWorld& world_;
  std::unique_ptr<NextPlace> next_place_;
  OwnMemory memory_;
  simulator::MyPoseButton my_pose_;
  std::optional<Announced> announced_;
  std::optional<Time> idle_since_;
};

}  // namespace tandem::experiment
