#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "services/planner/core/tasks/assignment_bound.hpp"
#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {

/// How much a course of events can still be worth at most: an optimist's estimate that no plan exceeds.
///
/// It takes mates to satisfy every relation at the earliest possible time and moving sources to be wherever an agent
/// likes (digest E3), and asks only: how soon can who be there, how much is in the pool, how fast can it be drawn, and,
/// for sources apart from each other, has each agent time enough for its drawing and for walking from source to source.
/// The last question goes to AssignmentBound.
class TaskBound {
 public:
  /// `model` must outlive it.
  explicit TaskBound(const TaskModel& model);

  /// At least the value of every plan that goes on from `state`, what was drawn so far included. A bound of at most
  /// `enough` is not made any tighter.
  [[nodiscard]] double operator()(const TaskState& state, double enough = -std::numeric_limits<double>::infinity());

 private:
  void find_footprints();
  void find_gaps();
  void find_twins();
  void find_reaches(const TaskState& state);
  [[nodiscard]] bool may_pass(const TaskLeg& leg, std::size_t source) const;
  [[nodiscard]] double opening_s(const TaskState& state, std::size_t source);
  [[nodiscard]] double span_s(const TaskState& state, std::size_t source, std::size_t agent);
  [[nodiscard]] double value_without_time(const TaskState& state, std::size_t pool);
  void add_item(const TaskState& state, std::size_t pool, std::vector<PoolItem>& items);
  [[nodiscard]] double settled_cost(const TaskState& state) const;
  [[nodiscard]] double entry_m(std::size_t source, std::size_t agent) const;
  [[nodiscard]] double distance_m(std::size_t source, const Eigen::Vector2d& point) const;

  const TaskModel& model_;
  std::size_t agents_ = 0;
  bool may_walk_slowly_ = false;                   ///< then walking may cost nothing
  std::vector<std::optional<PlanarShape>> shape_;  ///< by source; none: it may be anywhere
  std::vector<std::optional<Disc>> disc_;          ///< around the shape
  std::vector<double> peak_;                       ///< by source and agent, in units of the pool
  std::vector<std::vector<double>> gap_m_;         ///< between two sources, at least
  std::vector<bool> is_apart_;                     ///< of pools: nobody draws from it and another one at once
  std::vector<std::vector<std::size_t>> twins_;    ///< pools that are wholly codependent: they give as much as one
  // Of the state at hand:
  std::vector<std::uint8_t> hopeful_;    ///< by source and agent
  std::vector<double> reach_s_;          ///< by source and agent: earliest time in its boundary
  std::vector<double> rest_distance_m_;  ///< by source and agent: from where the agent is or ends its way
  std::vector<double> opening_s_;        ///< by source; negative: not known yet
  std::vector<double> time_left_s_;      ///< by agent
  std::vector<PoolItems> groups_;        ///< by twins
  AssignmentBound assigned_;
};

}  // namespace tandem
