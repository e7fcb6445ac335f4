#pragma once

#include <span>
#include <variant>
#include <vector>

#include "services/planner/core/srs/agent_move.hpp"
#include "services/planner/core/srs/boundary.hpp"

namespace tandem {

/// A shape fixed on the map, or in the frame of the agent with this number.
struct PlacedShape {
  PlanarShape shape;
  int owner = -1;  ///< -1: the map
};

/// An end of a moving corridor: an agent's number, or -1 and a point of the map.
struct ResolvedAnchor {
  int agent = -1;
  Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< [m]
};

struct MovingCorridor {
  ResolvedAnchor from;
  ResolvedAnchor to;
  double half_width_m = 0.0;
};

/// A boundary with agents as numbers, ready to be evaluated on the joint motion of all agents.
using ResolvedBoundary = std::variant<Nowhere, PlacedShape, MovingCorridor, SpeedInterval, Sphere, Box>;

/// All agents move at the same time, for the same while.
struct JointMove {
  std::span<const AgentMove> moves;  ///< by agent number
  double duration_s = 0.0;           ///< > 0
};

/// `agents` are the names of the agents, by number; those of the boundary must be among them.
[[nodiscard]] ResolvedBoundary resolved(const Boundary& boundary, const std::vector<std::string>& agents);

/// Whether the boundary has a place now: an event never has, one that belongs to an absent agent neither.
[[nodiscard]] bool is_somewhere(const ResolvedBoundary& boundary, const JointMove& joint);

/// The boundary vector of an agent at a share [0, 1] of the joint move; both motions are interpolated (digest B8). Its
/// direction is in the frame of the boundary; in the space of speeds it is +x for faster, and of a volume its
/// horizontal part. The boundary must be somewhere.
[[nodiscard]] BoundaryVector vector_to(const ResolvedBoundary& boundary, std::size_t agent, const JointMove& joint,
                                       double share);

/// The shape on the map that a planar boundary has at a share of the joint move; none for the other spaces, and where
/// it is nowhere.
[[nodiscard]] std::optional<PlanarShape> shape_at(const ResolvedBoundary& boundary, const JointMove& joint,
                                                  double share);

/// Appends the shares [0, 1] of the joint move at which the agent's signed distance is `level`, in no order; `level` 0
/// is the boundary itself.
///
/// Exact (roots of linear and quadratic equations) where the agent moves on a straight line in the frame of the
/// boundary: fixed and translating shapes, at any level but polygons' and boxes' other than 0. Else, for turning
/// frames and stretching corridors, by bisection that the largest relative speed makes safe: roots to 1e-12 of the
/// interval, and only contacts shorter than kShortestContact_s can be missed.
void append_level_crossings(const ResolvedBoundary& boundary, double level, std::size_t agent, const JointMove& joint,
                            std::vector<double>& shares);

/// The shortest contact with a turning or stretching boundary that is certainly seen [s].
inline constexpr double kShortestContact_s = 1e-4;

}  // namespace tandem
