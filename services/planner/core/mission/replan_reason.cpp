#include "services/planner/core/mission/replan_reason.hpp"

namespace tandem {
namespace {

constexpr double kHeard_s = 1.0;  ///< so long after its acceptance everybody has heard of it

}  // namespace

std::optional<std::string> replan_reason(const PlanSituation& situation, const PlannerConfig& config) {
  switch (situation.standing) {
    case PlanStanding::None:
      return "first plan";
    case PlanStanding::Rejected:
      return "the person rejected the plan";
    case PlanStanding::Superseded:
      if (situation.person_drew) return "the person drew on the map";
      return "the person asked for a new plan";
    case PlanStanding::Expired:
      return "the plan was not finished in time";
    case PlanStanding::Proposed:
    case PlanStanding::Accepted:
      break;
  }
  const bool edits_may_act = situation.standing == PlanStanding::Accepted
                                 ? situation.age_s >= config.acceptance_delay_s + kHeard_s
                                 : !situation.edits_must_wait;
  if (edits_may_act) {
    if (situation.person_said_where) return "the person knows something of where it is";
    if (situation.person_drew) return "the person drew on the map";
  }
  if (situation.blocked) return "the robot's path is blocked";
  if (situation.standing == PlanStanding::Accepted) {
    if (situation.robot_finished) return "the robot is at the end of its path";
    if (situation.goal_reached) return "the person reached their goal";
  }
  if (situation.person_is_new) return "the person is known now";
  if (situation.age_s < config.replan_pause_s) return std::nullopt;
  if (situation.robot_is_ahead) return "the robot is ahead of the person";
  if (situation.surprise > config.surprise) return "less was seen than planned";
  if (situation.person_off_plan_s > config.deviation_s) return "the person went another way";
  return std::nullopt;
}

}  // namespace tandem
