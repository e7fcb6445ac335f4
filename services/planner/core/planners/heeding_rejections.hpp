#pragma once

#include <memory>

#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// Any planner, kept from proposing a plan again that a person rejected (digest A6).
///
/// While nothing is rejected it is that planner. If its first plan is like a rejected one, a member is committed to
/// another first step, the best by new mass for the time of those that lead elsewhere, and the planner plans the rest;
/// the better one of the members' plans is improved on. Only if all first steps of all members lead to rejected plans,
/// a rejected plan comes out.
class HeedingRejections final : public Planner {
 public:
  explicit HeedingRejections(std::unique_ptr<Planner> planner) : planner_(std::move(planner)) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return planner_->rollouts(); }
  [[nodiscard]] JointPlan best() override;
  [[nodiscard]] bool shares_looks() const override { return planner_->shares_looks(); }
  [[nodiscard]] bool replans_under_way() const override { return planner_->replans_under_way(); }

 private:
  std::unique_ptr<Planner> planner_;
  SearchProblem problem_;  ///< what planner_ plans: with a first step, where one had to be given
  JointPlan best_;         ///< only while something is rejected
};

}  // namespace tandem
