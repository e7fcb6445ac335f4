#pragma once

#include "services/planner/core/baselines/one_plan_planner.hpp"

namespace tandem {

/// Cuts what is unseen into pieces, one a member, as large as it can sweep in the time it has, and lets each mow its
/// piece lane by lane, from the end it is nearer to.
[[nodiscard]] Routes lawnmower_routes(const PreparedProblem& problem);

/// Mows.
class LawnmowerPlanner final : public OnePlanPlanner {
 public:
  [[nodiscard]] bool replans_under_way() const override { return false; }

 private:
  [[nodiscard]] Routes routes(const PreparedProblem& problem) const override { return lawnmower_routes(problem); }
};

/// Points of an area in the order of mowing: in lanes of `lane_width_m` along the longer side of what the points span,
/// every other one backwards. The result are indices.
[[nodiscard]] std::vector<int> mowing_order(const std::vector<Eigen::Vector2d>& points, double lane_width_m);

}  // namespace tandem
