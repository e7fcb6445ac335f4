#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "services/planner/core/srs/reward_account.hpp"
#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem {

/// A decision: what an agent does next, or, before everything else, who is told what.
enum class TaskActionKind : std::uint8_t {
  Tell,       ///< no agent: the messages sent before the plan starts
  Visit,      ///< go to a station of a source and stay
  Accompany,  ///< be where a source is that moves with a mate, until that mate's action ends
  Goal,       ///< go to the goal a person fixed, and end there
  Hold,       ///< stay until a mate's action ends, then decide again
  Wait,       ///< stay for good (digest F5, F7)
};

/// When a visit ends, if not before: a source that can pay no more is left at once.
enum class StayEnd : std::uint8_t {
  Consumed,   ///< when the pool is empty, or time is up
  Triggered,  ///< when a relation that waits for this source takes effect
  InTimeFor,  ///< when it is just early enough to go and consume another one
};

struct TaskAction {
  TaskActionKind kind = TaskActionKind::Wait;
  StayEnd until = StayEnd::Consumed;
  std::int16_t agent = -1;
  std::int16_t source = -1;  ///< Of Tell: number of the message set.
  std::int16_t next = -1;    ///< Of InTimeFor: the other source.
  std::int16_t way = 0;      ///< Of Travel::ways.
  std::int32_t place = -1;   ///< Of the agent's Travel: where it goes.
  auto operator<=>(const TaskAction&) const = default;
};

/// A way with times, in whole milliseconds since its start (digest F9).
struct TaskLeg {
  struct Point {
    std::int64_t time_ms = 0;
    Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();
    double from_heading_rad = 0.0;  ///< of the piece that ends here, not wrapped
    double to_heading_rad = 0.0;
  };
  std::vector<Point> points;  ///< At least the start; times ascend.
  [[nodiscard]] std::int64_t duration_ms() const { return points.back().time_ms; }
};

enum class Occupation : std::uint8_t {
  Free,
  Committed,
  Visiting,
  Accompanying,
  GoingToGoal,
  Holding,
  Done,
};

/// What one agent is doing.
struct TaskAgentState {
  Occupation occupation = Occupation::Free;
  TaskAction action;
  int place = -1;  ///< Where it is or goes to; -1 where that is no place of its Travel yet.
  Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  const TaskLeg* leg = nullptr;  ///< The way it is on, or was last.
  std::int64_t leg_start_ms = 0;
  std::int64_t leave_ms = 0;  ///< When its stay ends at the latest.

  [[nodiscard]] std::int64_t arrival_ms() const {
    return leg == nullptr ? leg_start_ms : leg_start_ms + leg->duration_ms();
  }
};

/// A moment of a joint plan at which something is to be decided: equations (20), (21).
struct TaskState {
  std::int64_t now_ms = 0;
  std::int64_t makespan_ms = 0;  ///< End of the last action that ended.
  double value = 0.0;            ///< All reward so far, messages paid.
  std::int32_t told = -1;        ///< Number of the message set; -1: to be decided.
  RewardState rewards;
  std::array<TaskAgentState, kMaxTaskAgents> agents;
};

}  // namespace tandem
