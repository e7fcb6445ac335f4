#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/network/lab/laboratory.hpp"
#include "tests/support/simulated_team.hpp"

namespace tandem::test {

/// A team whose hosts are `robot` and `laptop` of the laboratory, and whose laptop has no map of its own. The simulated
/// phone, which is where the simulated world is, has a cable to the gateway: how a browser bears a bad air is tested
/// with the gateway.
[[nodiscard]] TeamOptions team_on(Laboratory& lab, const std::string& robot, const std::string& laptop);

/// Counts how often the robot of a team was stopped by something that was not there, from its first motion to the end
/// of its search.
class FalseStops {
 public:
  explicit FalseStops(SimulatedTeam& team);

  /// Reads what came; to be called a few times a second.
  void listen();
  /// Why the base held the robot back, each time it began to. A person may come close, and that is no false stop; all
  /// else that stops a robot is well in these searches.
  [[nodiscard]] const std::vector<msg::StopReason>& of_base() const { return of_base_; }
  /// How often the navigator stood because it had not heard of the plan for too long.
  [[nodiscard]] int for_want_of_a_plan() const { return for_want_of_a_plan_; }

 private:
  SimulatedTeam& team_;
  bus::InOrder<msg::BaseStatus, msg::BaseStatusPubSubType> base_;
  bus::InOrder<msg::PlanExecution, msg::PlanExecutionPubSubType> execution_;
  std::optional<Time> drives_since_;
  bool was_held_back_ = true;
  bool wanted_a_plan_ = true;
  std::vector<msg::StopReason> of_base_;
  int for_want_of_a_plan_ = 0;
};

}  // namespace tandem::test
