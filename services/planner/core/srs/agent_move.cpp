#include "services/planner/core/srs/agent_move.hpp"

#include <cassert>
#include <cmath>

namespace tandem {

AgentMove straight_move(const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map) {
  AgentMove move;
  move.from_in_map = from_in_map;
  move.to_in_map = to_in_map;
  const Eigen::Vector2d way = to_in_map - from_in_map;
  move.from_heading_rad = move.to_heading_rad = std::atan2(way.y(), way.x());
  return move;
}

AgentMove stay_at(const Eigen::Vector2d& point_in_map, double heading_rad) {
  AgentMove move;
  move.from_in_map = move.to_in_map = point_in_map;
  move.from_heading_rad = move.to_heading_rad = heading_rad;
  return move;
}

AgentMove part_of(const AgentMove& move, double from_share, double to_share) {
  assert(0.0 <= from_share && from_share <= to_share && to_share <= 1.0);
  AgentMove part = move;
  const Eigen::Vector2d way = move.to_in_map - move.from_in_map;
  part.from_in_map = move.from_in_map + from_share * way;
  part.to_in_map = move.from_in_map + to_share * way;
  part.from_altitude_m = std::lerp(move.from_altitude_m, move.to_altitude_m, from_share);
  part.to_altitude_m = std::lerp(move.from_altitude_m, move.to_altitude_m, to_share);
  part.from_heading_rad = std::lerp(move.from_heading_rad, move.to_heading_rad, from_share);
  part.to_heading_rad = std::lerp(move.from_heading_rad, move.to_heading_rad, to_share);
  return part;
}

AgentMove absent() {
  AgentMove move;
  move.present = false;
  return move;
}

}  // namespace tandem
