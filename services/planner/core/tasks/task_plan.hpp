#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "services/planner/core/motion/timed_path.hpp"
#include "services/planner/core/srs/mental_model.hpp"
#include "services/planner/core/srs/reward_account.hpp"

namespace tandem {

/// A stay at a source to consume it.
struct TaskVisit {
  std::size_t source = 0;  ///< Index in the world.
  double arrive_s = 0.0;
  double leave_s = 0.0;
  bool operator==(const TaskVisit&) const = default;
};

/// What one agent is to do.
struct TaskAgentPlan {
  TimedPath path;  ///< From the start; the agent waits at its end.
  std::vector<TaskVisit> visits;
  double reward = 0.0;  ///< All it draws until the horizon.
  double end_s = 0.0;   ///< When the last of its actions ends.
};

/// What is left in a source's pool at a time, signed.
struct DrainPoint {
  double time_s = 0.0;
  double left = 0.0;
};

/// A plan for the whole team, and what it is worth.
struct TaskPlan {
  std::vector<TaskAgentPlan> agents;
  std::vector<Inform> informs;  ///< To be said first: whom to tell about which source (digest D3).
  double value = 0.0;           ///< g: all reward until the horizon, messages paid; equations (15)-(19).
  double value_untold = 0.0;    ///< The best value found without any message; value, if there is none.
  double upper_bound = 0.0;     ///< No plan of these actions is worth more.
  double makespan_s = 0.0;      ///< When the last action of all ends.
  std::vector<std::vector<DrainPoint>> drains;  ///< Per source, by time; straight between two points.
  RewardRecord record;                          ///< Events and who was paid by which source.
  std::int64_t rollouts = 0;

  /// No plan is worth more, but for rounding.
  [[nodiscard]] bool is_proven() const { return upper_bound <= value + 1e-7 * std::max(1.0, std::abs(value)); }
};

}  // namespace tandem
