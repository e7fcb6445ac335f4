#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tandem {

/// Who a planner process is, as its heartbeat says.
struct PlannerIdentity {
  std::string host;
  std::uint32_t process_id = 0;

  friend bool operator==(const PlannerIdentity&, const PlannerIdentity&) = default;
};

/// A heartbeat that was heard since this process started.
struct PlannerHeartbeat {
  PlannerIdentity planner;
  std::string robot;         ///< it plans for
  bool is_starting = false;  ///< as this process
};

/// Why this process must not plan for `robot`: "planner already active on host X pid Y". Empty while nobody else does.
/// Of two that start at once, the one with the higher process id gives way.
[[nodiscard]] inline std::string refusal_to_plan(const std::string& robot, const PlannerIdentity& self,
                                                 const std::vector<PlannerHeartbeat>& heard) {
  for (const auto& heartbeat : heard) {
    const bool gives_way = heartbeat.is_starting && heartbeat.planner.process_id > self.process_id;
    if (heartbeat.robot == robot && heartbeat.planner != self && !gives_way) {
      return "planner already active on host " + heartbeat.planner.host + " pid " +
             std::to_string(heartbeat.planner.process_id);
    }
  }
  return {};
}

}  // namespace tandem
