#pragma once

#include <Eigen/Core>

namespace tandem {

/// What one agent does in an interval: it goes straight and turns evenly, or stays.
struct AgentMove {
  Eigen::Vector2d from_in_map = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d to_in_map = Eigen::Vector2d::Zero();    ///< [m]
  double from_altitude_m = 0.0;
  double to_altitude_m = 0.0;
  double from_heading_rad = 0.0;
  double to_heading_rad = 0.0;  ///< not wrapped: the way from one heading to the other is the turn
  bool present = true;          ///< An absent agent draws nothing, and what is attached to it is nowhere.

  bool operator==(const AgentMove&) const = default;
};

/// Going straight from one point to another, looking where it goes; on the spot, heading along x.
[[nodiscard]] AgentMove straight_move(const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map);

/// Staying at a point.
[[nodiscard]] AgentMove stay_at(const Eigen::Vector2d& point_in_map, double heading_rad = 0.0);

/// The part of a move between two shares of it, 0 <= from <= to <= 1.
[[nodiscard]] AgentMove part_of(const AgentMove& move, double from_share, double to_share);

/// The agent that is not there.
[[nodiscard]] AgentMove absent();

}  // namespace tandem
