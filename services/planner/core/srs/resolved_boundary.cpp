#include "services/planner/core/srs/resolved_boundary.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "services/planner/core/srs/safe_roots.hpp"
#include "services/planner/core/srs/segment_geometry.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

int number_of(const std::string& agent, const std::vector<std::string>& agents) {
  if (agent.empty()) return -1;
  const auto found = std::ranges::find(agents, agent);
  assert(found != agents.end());
  return static_cast<int>(found - agents.begin());
}

const AgentMove& move_of(int agent, const JointMove& joint) {
  return joint.moves[static_cast<std::size_t>(agent)];
}

Vector2d position(const AgentMove& move, double share) {
  return move.from_in_map + share * (move.to_in_map - move.from_in_map);
}

Vector3d position_in_space(const AgentMove& move, double share) {
  const Vector2d flat = position(move, share);
  return {flat.x(), flat.y(), std::lerp(move.from_altitude_m, move.to_altitude_m, share)};
}

double speed_of(const AgentMove& move, double duration_s) {
  return (position_in_space(move, 1.0) - position_in_space(move, 0.0)).norm() / duration_s;
}

/// Where the agent is in the frame of the shape.
Vector2d position_in_shape(const PlacedShape& placed, const AgentMove& move, const JointMove& joint, double share) {
  const Vector2d point = position(move, share);
  if (placed.owner < 0) return point;
  const AgentMove& owner = move_of(placed.owner, joint);
  const Vector2d offset = point - position(owner, share);
  const double heading = std::lerp(owner.from_heading_rad, owner.to_heading_rad, share);
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  return {c * offset.x() + s * offset.y(), -s * offset.x() + c * offset.y()};
}

Vector2d anchor_at(const ResolvedAnchor& anchor, const JointMove& joint, double share) {
  return anchor.agent < 0 ? anchor.point_in_map : position(move_of(anchor.agent, joint), share);
}

Vector2d way_of(const ResolvedAnchor& anchor, const JointMove& joint) {
  return anchor_at(anchor, joint, 1.0) - anchor_at(anchor, joint, 0.0);
}

struct VectorTo {
  const AgentMove& move;
  const JointMove& joint;
  double share;

  BoundaryVector operator()(const Nowhere&) const {
    assert(false);
    return {};
  }
  BoundaryVector operator()(const PlacedShape& placed) const {
    return vector_to(placed.shape, position_in_shape(placed, move, joint, share));
  }
  BoundaryVector operator()(const MovingCorridor& corridor) const {
    return vector_from_capsule(anchor_at(corridor.from, joint, share), anchor_at(corridor.to, joint, share),
                               corridor.half_width_m, position(move, share));
  }
  BoundaryVector operator()(const SpeedInterval& speeds) const {
    const double speed = speed_of(move, joint.duration_s);
    const double above = speed - speeds.min_mps;
    const double below = speeds.max_mps - speed;
    const bool near_min = above <= below;
    const double distance = -std::min(above, below);
    const bool outwards_up = near_min == (distance < 0.0);  // inside: away from the nearer end; else away from it
    return {distance, outwards_up ? Vector2d{1.0, 0.0} : Vector2d{-1.0, 0.0}};
  }
  BoundaryVector operator()(const Sphere& sphere) const {
    const Vector3d offset = position_in_space(move, share) - sphere.centre_in_map;
    const double distance = offset.norm() - sphere.radius_m;
    return {distance, horizontal(distance < 0.0 ? Vector3d{-offset} : offset)};
  }
  BoundaryVector operator()(const Box& box) const {
    const Vector3d point = position_in_space(move, share);
    const Vector3d outside = (box.low_in_map - point).cwiseMax(point - box.high_in_map);
    const double distance = outside.maxCoeff() > 0.0 ? outside.cwiseMax(0.0).norm() : outside.maxCoeff();
    const Vector3d middle = 0.5 * (box.low_in_map + box.high_in_map);
    return {distance, horizontal(distance < 0.0 ? Vector3d{middle - point} : Vector3d{point - middle})};
  }
  static Vector2d horizontal(const Vector3d& offset) {
    const Vector2d flat = offset.head<2>();
    return flat.norm() > kOnBoundary_m ? Vector2d{flat.normalized()} : Vector2d{1.0, 0.0};
  }
};

struct AppendCrossings {
  const ResolvedBoundary& boundary;
  double level;
  std::size_t agent;
  const JointMove& joint;
  std::vector<double>& shares;

  const AgentMove& move() const { return joint.moves[agent]; }

  /// `change` is how much the distance can change over the whole interval, at most.
  void search(double change) const {
    const auto distance = [&](double share) { return vector_to(boundary, agent, joint, share).distance - level; };
    append_safe_roots(distance, change, kShortestContact_s / joint.duration_s, kOnBoundary_m, shares);
  }

  void operator()(const Nowhere&) const {}
  void operator()(const SpeedInterval&) const {}  // the speed does not change within a move
  void operator()(const PlacedShape& placed) const {
    const Vector2d from = position_in_shape(placed, move(), joint, 0.0);
    const Vector2d to = position_in_shape(placed, move(), joint, 1.0);
    double turn_rad = 0.0;
    Vector2d way = to - from;
    if (placed.owner >= 0) {
      const AgentMove& owner = move_of(placed.owner, joint);
      turn_rad = std::abs(owner.to_heading_rad - owner.from_heading_rad);
      way = (position(move(), 1.0) - position(owner, 1.0)) - (position(move(), 0.0) - position(owner, 0.0));
    }
    if (turn_rad == 0.0 && append_level_crossings(placed.shape, level, from, to, shares)) return;
    search(way.norm() + turn_rad * std::max(from.norm(), to.norm()));
  }
  void operator()(const MovingCorridor& corridor) const {
    const Vector2d way = way_of(corridor.from, joint);
    const Vector2d other_way = way_of(corridor.to, joint);
    if (way == other_way) {
      append_capsule_crossings(anchor_at(corridor.from, joint, 0.0), anchor_at(corridor.to, joint, 0.0),
                               corridor.half_width_m + level, position(move(), 0.0), position(move(), 1.0) - way,
                               shares);
      return;
    }
    const Vector2d own_way = position(move(), 1.0) - position(move(), 0.0);
    search(std::max((own_way - way).norm(), (own_way - other_way).norm()));
  }
  void operator()(const Sphere& sphere) const {
    const Vector3d offset = position_in_space(move(), 0.0) - sphere.centre_in_map;
    const Vector3d way = position_in_space(move(), 1.0) - position_in_space(move(), 0.0);
    const double radius = sphere.radius_m + level;
    if (radius < 0.0) return;
    append_quadratic_roots(way.squaredNorm(), offset.dot(way), offset.squaredNorm() - radius * radius, shares);
  }
  void operator()(const Box& box) const {
    const Vector3d from = position_in_space(move(), 0.0);
    const Vector3d way = position_in_space(move(), 1.0) - from;
    if (level != 0.0) return search(way.norm());
    const std::size_t before = shares.size();
    for (int axis = 0; axis < 3; ++axis) {
      if (way[axis] == 0.0) continue;
      append_share((box.low_in_map[axis] - from[axis]) / way[axis], shares);
      append_share((box.high_in_map[axis] - from[axis]) / way[axis], shares);
    }
    const auto is_elsewhere = [&](double share) {
      return std::abs(vector_to(boundary, agent, joint, share).distance) > kOnBoundary_m;
    };
    shares.erase(std::remove_if(shares.begin() + static_cast<std::ptrdiff_t>(before), shares.end(), is_elsewhere),
                 shares.end());
  }
};

}  // namespace

ResolvedBoundary resolved(const Boundary& boundary, const std::vector<std::string>& agents) {
  if (const auto shape = shape_in_map(boundary)) return PlacedShape{*shape, -1};
  if (const auto* attached = std::get_if<Attached>(&boundary)) {
    return PlacedShape{attached->shape_in_agent, number_of(attached->agent, agents)};
  }
  if (const auto* between = std::get_if<Between>(&boundary)) {
    return MovingCorridor{{number_of(between->from.agent, agents), between->from.point_in_map},
                          {number_of(between->to.agent, agents), between->to.point_in_map},
                          between->half_width_m};
  }
  if (const auto* speeds = std::get_if<SpeedInterval>(&boundary)) return *speeds;
  if (const auto* sphere = std::get_if<Sphere>(&boundary)) return *sphere;
  if (const auto* box = std::get_if<Box>(&boundary)) return *box;
  return Nowhere{};
}

bool is_somewhere(const ResolvedBoundary& boundary, const JointMove& joint) {
  const auto is_there = [&](int agent) { return agent < 0 || move_of(agent, joint).present; };
  if (const auto* placed = std::get_if<PlacedShape>(&boundary)) return is_there(placed->owner);
  if (const auto* corridor = std::get_if<MovingCorridor>(&boundary)) {
    return is_there(corridor->from.agent) && is_there(corridor->to.agent);
  }
  return !std::holds_alternative<Nowhere>(boundary);
}

std::optional<PlanarShape> shape_at(const ResolvedBoundary& boundary, const JointMove& joint, double share) {
  if (!is_somewhere(boundary, joint)) return std::nullopt;
  if (const auto* corridor = std::get_if<MovingCorridor>(&boundary)) {
    return Corridor{{anchor_at(corridor->from, joint, share), anchor_at(corridor->to, joint, share)},
                    corridor->half_width_m};
  }
  const auto* placed = std::get_if<PlacedShape>(&boundary);
  if (placed == nullptr) return std::nullopt;
  if (placed->owner < 0) return placed->shape;
  const AgentMove& owner = move_of(placed->owner, joint);
  return moved(placed->shape, position(owner, share), std::lerp(owner.from_heading_rad, owner.to_heading_rad, share));
}

BoundaryVector vector_to(const ResolvedBoundary& boundary, std::size_t agent, const JointMove& joint, double share) {
  return std::visit(VectorTo{joint.moves[agent], joint, share}, boundary);
}

void append_level_crossings(const ResolvedBoundary& boundary, double level, std::size_t agent, const JointMove& joint,
                            std::vector<double>& shares) {
  std::visit(AppendCrossings{boundary, level, agent, joint, shares}, boundary);
}

}  // namespace tandem
