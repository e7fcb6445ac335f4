#pragma once

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// The id of the event that ends a search: the object is found (digest G6).
inline constexpr const char* kFoundId = "found";

/// A search cell as a source: pays the probability that the object is detected there, at `detection_rate_per_s` times
/// the joint probability `joint_mass` that it is there and was not seen yet (digest G2). Equation (28), corrected.
[[nodiscard]] RewardSource search_cell_source(const std::string& id, const Boundary& visible_from, double joint_mass,
                                              double detection_rate_per_s);

/// The event "found": no place, consumed by finding.
[[nodiscard]] RewardSource found_event();

/// The place a person asked `agent` to go to, its own or the robot's (digest H1).
[[nodiscard]] RewardSource goal_source(const std::string& agent, const Eigen::Vector2d& point_in_map, double reach_m);

/// The world of a search: every cell pays only until the object is found, equations (29) and (30).
[[nodiscard]] RewardWorld search_world(std::vector<RewardSource> cells);

}  // namespace tandem
