#pragma once

#include "services/common/time.hpp"

namespace tandem {

/// What has become of a plan (design: plan acceptance).
enum class PlanStanding { None, Proposed, Accepted, Rejected, Superseded, Expired };

/// Follows one plan from its proposal: accepted after a delay without a Replan, never executed past its validity.
class PlanAcceptance {
 public:
  explicit PlanAcceptance(Duration acceptance_delay) : acceptance_delay_(acceptance_delay) {}

  /// A new plan is proposed; the one before is superseded. `shown`: since when the team has been reading it, or a plan
  /// so like it that it need not be read again.
  void propose(Time shown, Time valid_until);
  /// The person pressed Replan: a proposal is rejected, a plan under way superseded.
  void replan(Time now);
  /// Something else makes the plan void: superseded.
  void withdraw();
  /// Forgets everything, as between sessions.
  void clear() { standing_ = PlanStanding::None; }

  /// Where the plan stands at `now`.
  [[nodiscard]] PlanStanding standing(Time now) const;
  /// Whether a robot may execute it at `now`.
  [[nodiscard]] bool may_execute(Time now) const { return standing(now) == PlanStanding::Accepted; }

 private:
  Duration acceptance_delay_;
  PlanStanding standing_ = PlanStanding::None;  ///< Proposed stands for Accepted and Expired too: time decides
  Time proposed_{};
  Time valid_until_{};
};

}  // namespace tandem
