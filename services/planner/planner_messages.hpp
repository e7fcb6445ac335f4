#pragma once

#include <optional>
#include <string>

#include "idl/topics.hpp"
#include "services/planner/core/mission/search_mission.hpp"
#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

// From the bus; what is not usable is none.

[[nodiscard]] std::optional<OccupancyGrid> to_core(const msg::OccupancyGrid& message);
[[nodiscard]] std::optional<Pose2> to_core(const msg::Pose& message);
[[nodiscard]] std::optional<PersonRequest> to_core(const msg::HumanMessage& message);
[[nodiscard]] RobotProgress to_core(const msg::PlanExecution& message);

// To the bus.

/// Who publishes, for whom.
struct PlanEnvelope {
  std::string robot;
  std::string session;
  std::string planner;
  std::uint64_t sequence_number = 0;
  Time now{};
};
[[nodiscard]] msg::TeamPlan to_message(const MissionPlan& plan, PlanStanding standing, const PlanEnvelope& envelope);
/// The belief of a mission whose area is known.
[[nodiscard]] msg::SearchBelief belief_message(const SearchMission& mission, const std::string& robot, Time now);
[[nodiscard]] msg::PlannerStatus status_message(const SearchMission& mission, const std::string& robot,
                                                double computing_s, Time now);
[[nodiscard]] msg::RewardSource to_message(const RewardSource& source);
[[nodiscard]] msg::SourceRelation to_message(const Relation& relation);

}  // namespace tandem
