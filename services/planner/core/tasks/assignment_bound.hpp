#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem {

/// What an agent would get for emptying a pool alone, and what of its time that takes.
struct PoolOffer {
  double value = 0.0;
  double time_s = 0.0;
  double share = 0.0;  ///< Of the pool that it can draw at most; of an unlimited one, 1 is all it can draw.
};

/// A pool and what each agent could do about it.
struct PoolItem {
  bool is_limited = true;  ///< The shares of all agents are at most 1 together.
  std::array<PoolOffer, kMaxTaskAgents> offers;
};

/// Pools that together give no more than so much.
struct PoolItems {
  std::vector<PoolItem> items;
  double most = 0.0;
};

/// An upper bound on what agents with limited time can draw from pools: the fractional assignment of pools to agents.
///
/// Any prices of the agents' time bound it from above (Lagrange): the price of all time there is, and for each pool the
/// best of what offers are worth beyond the price of their time. Good prices are looked for one agent at a time; the
/// bound is convex in each.
class AssignmentBound {
 public:
  /// `time_left_s` [s] by agent. A bound of at most `enough` is not made any tighter.
  [[nodiscard]] double operator()(const std::vector<PoolItems>& groups, const std::vector<double>& time_left_s,
                                  double enough = -std::numeric_limits<double>::infinity());

 private:
  [[nodiscard]] double priced(const std::vector<PoolItems>& groups, const std::vector<double>& time_left_s) const;

  std::array<double, kMaxTaskAgents> price_per_s_{};
};

}  // namespace tandem
