#pragma once

#include <vector>

#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {

/// How much a course of events can still be worth at most: an optimist's estimate that no plan exceeds.
///
/// It takes mates to satisfy every relation at the earliest possible time and moving sources to be wherever an agent
/// likes (digest E3), and asks only: how soon can anybody be there, how much is in the pool, how fast can it be drawn,
/// and, for sources apart from each other, is there time enough in the team for all the drawing and walking between
/// them (a fractional knapsack over the agents' time).
class TaskBound {
 public:
  /// `model` must outlive it.
  explicit TaskBound(const TaskModel& model);

  /// At least the value of every plan that goes on from `state`, what was drawn so far included.
  [[nodiscard]] double operator()(const TaskState& state);

 private:
  /// What a pool can still give, and what time it costs the team.
  struct Item {
    double value = 0.0;
    double time_s = 0.0;
  };

  void find_reaches(const TaskState& state);
  [[nodiscard]] double opening_s(const TaskState& state, std::size_t source);
  [[nodiscard]] Item item_of(const TaskState& state, std::size_t pool);
  [[nodiscard]] double settled_cost(const TaskState& state) const;
  [[nodiscard]] double entry_s(std::size_t source) const;
  [[nodiscard]] double distance_m(std::size_t source, const Eigen::Vector2d& point) const;

  const TaskModel& model_;
  double top_speed_mps_ = 0.0;
  double walking_cost_per_s_ = 0.0;  ///< what a second of walking costs anybody at least
  std::vector<std::optional<PlanarShape>> shape_;  ///< by source; none: it may be anywhere
  std::vector<double> peak_;                       ///< by source and agent, in units of the pool
  std::vector<std::vector<double>> gap_m_;         ///< between two sources, at least
  std::vector<bool> is_apart_;                     ///< of pools: nobody draws from it and another one at once
  std::vector<std::vector<std::size_t>> twins_;    ///< pools that are wholly codependent with each other
  // Of the state at hand:
  std::vector<bool> hopeful_;           ///< by source and agent
  std::vector<double> reach_s_;         ///< by source and agent: earliest time in its boundary
  std::vector<double> rest_distance_m_; ///< by source: from where an agent is or ends its way
  std::vector<double> opening_s_;       ///< by source; negative: not known yet
  std::vector<Item> items_;
};

}  // namespace tandem
