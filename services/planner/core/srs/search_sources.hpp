#pragma once

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// The id of the event that ends a search: the object is found (digest G6).
inline constexpr const char* kFoundId = "found";

/// A search cell as a source: pays the probability that the object is detected there, at `detection_rate_per_s` times
/// the joint probability `joint_mass` that it is there and was not seen yet (digest G2). Equation (28), corrected.
/// Who detects faster or slower has another pace there.
[[nodiscard]] RewardSource search_cell_source(const std::string& id, const Boundary& visible_from, double joint_mass,
                                              double detection_rate_per_s);

/// The event "found": no place. It happens with the probability that the cells pay, or is consumed by finding.
[[nodiscard]] RewardSource found_event();

/// What a second of searching costs an agent until the object is found: in expectation `agent` gets minus the expected
/// time times `cost_per_s` (digest A1).
[[nodiscard]] RewardSource time_cost_source(const std::string& agent, double cost_per_s);

/// The place a person asked `agent` to go to, its own or the robot's (digest H1).
[[nodiscard]] RewardSource goal_source(const std::string& agent, const Eigen::Vector2d& point_in_map, double reach_m);

/// The world of a search: every source given pays only until the object is found, equations (29) and (30).
[[nodiscard]] RewardWorld search_world(std::vector<std::string> agents, std::vector<RewardSource> until_found);

}  // namespace tandem
