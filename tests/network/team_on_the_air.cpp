#include "tests/network/team_on_the_air.hpp"

#include <algorithm>

namespace tandem::test {
namespace {

bool is_false(msg::StopReason reason) {
  return reason != msg::STOP_NONE && reason != msg::STOP_NOT_ENABLED && reason != msg::STOP_OBSTACLE;
}

}  // namespace

TeamOptions team_on(Laboratory& lab, const std::string& robot, const std::string& laptop) {
  TeamOptions options;
  options.robot = robot;
  options.without = {"camera", "laptop-of-" + robot + "/map-server"};
  options.gateway_address = lab.join_by_cable(robot, laptop);
  const auto network = [&lab](const std::string& own, const std::string& other) {
    return HostNetwork{.run = [&host = lab.host(own)](const std::function<void()>& work) { host.run(work); },
                       .link = LinkPlace{.peers = {lab.host(other).address()}}};
  };
  options.robot_network = network(robot, laptop);
  options.laptop_network = network(laptop, robot);
  return options;
}

FalseStops::FalseStops(SimulatedTeam& team)
    : team_(team),
      base_(team.robot_bus().in_order(topic::kBaseStatus)),
      execution_(team.robot_bus().in_order(topic::kPlanExecution)) {}

void FalseStops::listen() {
  const auto counts = [&](Time received) {
    return drives_since_ && received >= *drives_since_ && !team_.episode().is_over();
  };
  for (const auto& execution : execution_.take()) {
    if (!drives_since_ && execution.message.moving()) drives_since_ = execution.received;
    const bool wants_a_plan = execution.message.reason() == "the planner no longer repeats its plan";
    if (wants_a_plan && !wanted_a_plan_ && counts(execution.received)) ++for_want_of_a_plan_;
    wanted_a_plan_ = wants_a_plan;
  }
  for (const auto& status : base_.take()) {
    const auto& reasons = status.message.stop_reasons();
    const auto reason = std::find_if(reasons.begin(), reasons.end(), is_false);
    const bool held_back = reason != reasons.end();
    // Before it first drives, the hosts are still finding each other: what holds it back then stops nothing.
    if (held_back && !was_held_back_ && counts(status.received)) of_base_.push_back(*reason);
    was_held_back_ = held_back;
  }
}

}  // namespace tandem::test
