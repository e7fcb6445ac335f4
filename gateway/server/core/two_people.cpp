#include "gateway/server/core/two_people.hpp"

#include <algorithm>
#include <utility>

namespace tandem::gateway {

using protocol::CommandKind;

void TwoPeople::note(const std::string& agent, const protocol::Command& command, Time pressed) {
  Person& person = people_[agent];
  if (command.kind == CommandKind::MyPose) {
    person.pose = command.point_in_map;
    person.heading = command.heading.value_or(0.0);
    person.posed = pressed;
  } else if (command.kind == CommandKind::MyGoal) {
    person.goal = command.point_in_map;
  } else if (command.kind == CommandKind::ClearMyGoal) {
    person.goal.reset();
  }
}

std::optional<protocol::PersonState> TwoPeople::state_of(const std::string& agent, Time now) const {
  const auto found = people_.find(agent);
  if (found == people_.end() || !found->second.pose) return std::nullopt;
  const Person& person = found->second;
  return protocol::PersonState{.position = *person.pose,
                               .heading = person.heading,
                               .source = "message",
                               .tracked = true,
                               .age_s = std::max(0.0, to_seconds(now - person.posed)),
                               .goal = person.goal};
}

bool is_between_people(CommandKind kind) {
  switch (kind) {
    case CommandKind::MyPose:
    case CommandKind::MyGoal:
    case CommandKind::ClearMyGoal:
    case CommandKind::Found:
      return true;
    default:
      return false;
  }
}

protocol::State mirrored(protocol::State state) {
  std::swap(state.person, state.partner);
  return state;
}

}  // namespace tandem::gateway
