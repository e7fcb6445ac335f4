#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A place that turned out to be blocked.
struct BlockedDisc {
  Eigen::Vector2d centre_in_map;  ///< [m]
  double radius_m = 0.6;
};

/// What a body needs to get through.
struct MotionOptions {
  double radius_m = 0.3;               ///< clearance it must have
  double preferred_clearance_m = 0.6;  ///< ways with less cost more
  double node_spacing_m = 0.2;
  double clearance_weight = 2.0;  ///< a metre along a wall costs so many metres more than one in the open
};

/// The cheapest ways from one place to all others.
struct ShortestPaths {
  int from = -1;
  std::vector<float> cost_m;  ///< per node, infinite where no way leads
  std::vector<int> previous;  ///< node before, -1 at the start
};

/// Where a body of some size can stand and go: a lattice of nodes, each with clearance, joined to its eight neighbours.
class MotionMap {
 public:
  /// A neighbour and what it costs to go there.
  struct Edge {
    std::int32_t to;
    float cost_m;
  };

  MotionMap(const OccupancyGrid& map, const MotionOptions& options, const std::vector<BlockedDisc>& blocked = {});

  [[nodiscard]] int size() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] const Eigen::Vector2d& point(int node) const { return points_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] std::span<const Edge> edges(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return {edges_.data() + first_edge_[n], edges_.data() + first_edge_[n + 1]};
  }
  /// The nearest node within `reach_m` of the point.
  [[nodiscard]] std::optional<int> nearest_node(const Eigen::Vector2d& point_in_map, double reach_m) const;
  [[nodiscard]] ShortestPaths shortest_paths(int from) const { return shortest_paths(from, {}); }
  /// As above, where a metre near a node costs `surcharge` of that node more (>= 0); empty: nothing anywhere.
  [[nodiscard]] ShortestPaths shortest_paths(int from, std::span<const float> surcharge) const;
  /// The way of `paths` to `node` as few straight pieces; empty where no way leads. It begins at `start_in_map` and
  /// ends at `end_in_map`, points near the first and the last node; of two that are one, only one is left.
  [[nodiscard]] std::vector<Eigen::Vector2d> way(const ShortestPaths& paths, int node,
                                                 const Eigen::Vector2d& start_in_map,
                                                 const Eigen::Vector2d& end_in_map) const;
  /// A way along `nodes`, neighbours each, as few straight pieces. Corners are cut only where that brings it no nearer
  /// to walls than it was or than preferred.
  [[nodiscard]] std::vector<Eigen::Vector2d> way(std::span<const int> nodes, const Eigen::Vector2d& start_in_map,
                                                 const Eigen::Vector2d& end_in_map) const;
  /// The least clearance on the straight line between two points [m], at most 2 m.
  [[nodiscard]] double clearance_m(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

 private:
  void add_nodes(const OccupancyGrid& map);
  void add_edges();
  [[nodiscard]] int node_at(int column, int row) const;
  [[nodiscard]] bool has_clearance(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double room_m) const;
  [[nodiscard]] bool is_blocked(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  MotionOptions options_;
  DistanceField clearance_;
  std::vector<BlockedDisc> blocked_;
  Pose2 map_from_lattice_;
  double spacing_m_ = 0.2;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::int32_t> node_of_;  ///< per block of the lattice, -1: none
  std::vector<Eigen::Vector2d> points_;
  std::vector<std::uint32_t> first_edge_;  ///< per node and one more
  std::vector<Edge> edges_;
};

}  // namespace tandem
