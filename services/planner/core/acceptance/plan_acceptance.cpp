#include "services/planner/core/acceptance/plan_acceptance.hpp"

namespace tandem {

void PlanAcceptance::propose(Time shown, Time valid_until) {
  standing_ = PlanStanding::Proposed;
  proposed_ = shown;
  valid_until_ = valid_until;
}

void PlanAcceptance::replan(Time now) {
  const PlanStanding before = standing(now);
  if (before == PlanStanding::Proposed) standing_ = PlanStanding::Rejected;
  if (before == PlanStanding::Accepted) standing_ = PlanStanding::Superseded;
}

void PlanAcceptance::withdraw() {
  if (standing_ == PlanStanding::Proposed) standing_ = PlanStanding::Superseded;
}

PlanStanding PlanAcceptance::standing(Time now) const {
  if (standing_ != PlanStanding::Proposed) return standing_;
  if (now > valid_until_) return PlanStanding::Expired;
  return now - proposed_ >= acceptance_delay_ ? PlanStanding::Accepted : PlanStanding::Proposed;
}

}  // namespace tandem
