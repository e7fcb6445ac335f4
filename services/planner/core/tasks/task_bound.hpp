#pragma once

#include <array>
#include <optional>
#include <vector>

#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {

/// How much a course of events can still be worth at most: an optimist's estimate that no plan exceeds.
///
/// It takes mates to satisfy every relation at the earliest possible time and moving sources to be wherever an agent
/// likes (digest E3), and asks only: how soon can who be there, how much is in the pool, how fast can it be drawn, and,
/// for sources apart from each other, has each agent time enough for its drawing and for walking from source to source.
/// The last question is a fractional assignment of pools to agents with limited time; any prices on the agents' time
/// bound it from above (Lagrange), and good ones are looked for.
class TaskBound {
 public:
  /// `model` must outlive it.
  explicit TaskBound(const TaskModel& model);

  /// At least the value of every plan that goes on from `state`, what was drawn so far included.
  [[nodiscard]] double operator()(const TaskState& state);

 private:
  /// What an agent would get for emptying a pool alone, and what of its time that takes.
  struct Offer {
    double value = 0.0;
    double time_s = 0.0;
    double share = 0.0;  ///< of the pool that it can draw at most; of an unlimited one, 1 is all it can draw
  };
  /// Sources of which nobody draws two at once.
  struct Item {
    std::size_t pool = 0;
    bool is_limited = true;  ///< the shares of all agents are at most 1 together
    std::array<Offer, kMaxTaskAgents> offers;
  };
  /// Pools that are wholly codependent: together they give no more than the fullest of them.
  struct Twins {
    std::vector<std::size_t> pools;
    std::size_t first_item = 0;
    std::size_t last_item = 0;  ///< one past
    double most = 0.0;          ///< value of all of them together
  };

  void find_footprints();
  void find_gaps();
  void find_twins();
  void find_reaches(const TaskState& state);
  [[nodiscard]] bool may_pass(const TaskLeg& leg, std::size_t source) const;
  [[nodiscard]] double opening_s(const TaskState& state, std::size_t source);
  [[nodiscard]] double span_s(const TaskState& state, std::size_t source, std::size_t agent);
  [[nodiscard]] double value_without_time(const TaskState& state, std::size_t pool);
  void add_item(const TaskState& state, std::size_t pool);
  [[nodiscard]] double settled_cost(const TaskState& state) const;
  [[nodiscard]] double entry_m(std::size_t source, std::size_t agent) const;
  [[nodiscard]] double distance_m(std::size_t source, const Eigen::Vector2d& point) const;
  [[nodiscard]] double priced() const;
  [[nodiscard]] double least_priced();

  const TaskModel& model_;
  std::size_t agents_ = 0;
  bool may_walk_slowly_ = false;                   ///< then walking may cost nothing
  std::vector<std::optional<PlanarShape>> shape_;  ///< by source; none: it may be anywhere
  std::vector<std::optional<Disc>> disc_;          ///< around the shape
  std::vector<double> peak_;                       ///< by source and agent, in units of the pool
  std::vector<std::vector<double>> gap_m_;         ///< between two sources, at least
  std::vector<bool> is_apart_;                     ///< of pools: nobody draws from it and another one at once
  std::vector<Twins> twins_;
  // Of the state at hand:
  std::vector<std::uint8_t> hopeful_;    ///< by source and agent
  std::vector<double> reach_s_;          ///< by source and agent: earliest time in its boundary
  std::vector<double> rest_distance_m_;  ///< by source and agent: from where the agent is or ends its way
  std::vector<double> opening_s_;        ///< by source; negative: not known yet
  std::vector<Item> items_;
  std::array<double, kMaxTaskAgents> time_left_s_{};
  std::array<double, kMaxTaskAgents> price_per_s_{};
};

}  // namespace tandem
