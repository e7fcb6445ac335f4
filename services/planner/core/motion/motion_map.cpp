#include "services/planner/core/motion/motion_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kClearanceLimit_m = 2.0;
constexpr double kSampling_m = 0.1;
constexpr double kSamePoint_m = 1e-6;
constexpr double kSlack_m = 0.02;       ///< of clearance, for what lies between the map's cells
constexpr std::size_t kLookAhead = 80;  ///< nodes over which a corner may be cut

}  // namespace

MotionMap::MotionMap(const OccupancyGrid& map, const MotionOptions& options, const std::vector<BlockedDisc>& blocked)
    : options_(options), clearance_(map, kClearanceLimit_m, Obstacles::OccupiedOrUnknown), blocked_(blocked) {
  const int side = std::max(1, static_cast<int>(std::lround(options.node_spacing_m / map.resolution_m())));
  const int columns = (map.width() + side - 1) / side;
  const int rows = (map.height() + side - 1) / side;
  std::vector<int> node_of(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -1);
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      // The middle of the block if it is in the open, else its place with the most room.
      CellIndex best{column * side + side / 2, row * side + side / 2};
      if (!map.contains(best) || clearance_.at(best) < options.preferred_clearance_m) {
        double best_m = -1.0;
        for (int y = row * side; y < std::min(map.height(), (row + 1) * side); ++y) {
          for (int x = column * side; x < std::min(map.width(), (column + 1) * side); ++x) {
            if (clearance_.at({x, y}) > best_m) {
              best_m = clearance_.at({x, y});
              best = {x, y};
            }
          }
        }
      }
      if (!map.is_free(best) || clearance_.at(best) < options.radius_m) continue;
      const Vector2d point = map.centre_in_map(best);
      if (std::ranges::any_of(
              blocked_, [&](const BlockedDisc& disc) { return (disc.centre_in_map - point).norm() < disc.radius_m; })) {
        continue;
      }
      node_of[index(column, row)] = size();
      points_.push_back(point);
    }
  }
  edges_.resize(points_.size());
  constexpr CellIndex kHalfOfNeighbours[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int node = node_of[index(column, row)];
      if (node < 0) continue;
      for (const auto& [right, up] : kHalfOfNeighbours) {
        const int x = column + right;
        const int y = row + up;
        if (x < 0 || x >= columns || y >= rows || node_of[index(x, y)] < 0) continue;
        const int other = node_of[index(x, y)];
        const double room_m = clearance_m(point(node), point(other));
        if (room_m < options.radius_m - kSlack_m) continue;
        const double shortfall = std::max(0.0, options.preferred_clearance_m - room_m) / options.preferred_clearance_m;
        const auto cost_m =
            static_cast<float>((point(node) - point(other)).norm() * (1.0 + options.clearance_weight * shortfall));
        edges_[static_cast<std::size_t>(node)].push_back({other, cost_m});
        edges_[static_cast<std::size_t>(other)].push_back({node, cost_m});
      }
    }
  }
}

double MotionMap::clearance_m(const Vector2d& from, const Vector2d& to) const {
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSampling_m)));
  double least_m = kClearanceLimit_m;
  for (int i = 0; i <= pieces; ++i) {
    least_m = std::min(least_m, static_cast<double>(clearance_.nearest(from + (to - from) * i / pieces)));
  }
  for (const auto& disc : blocked_) {
    const double length2 = (to - from).squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp((disc.centre_in_map - from).dot(to - from) / length2, 0.0, 1.0) : 0.0;
    if ((from + share * (to - from) - disc.centre_in_map).norm() < disc.radius_m) return 0.0;
  }
  return least_m;
}

std::optional<int> MotionMap::nearest_node(const Vector2d& point_in_map, double reach_m) const {
  std::optional<int> nearest;
  double nearest_m = reach_m;
  for (int node = 0; node < size(); ++node) {
    const double distance_m = (point(node) - point_in_map).norm();
    if (distance_m < nearest_m || (distance_m == nearest_m && !nearest)) {
      nearest_m = distance_m;
      nearest = node;
    }
  }
  return nearest;
}

ShortestPaths MotionMap::shortest_paths(int from, std::span<const float> surcharge) const {
  ShortestPaths paths;
  paths.from = from;
  paths.cost_m.assign(points_.size(), std::numeric_limits<float>::infinity());
  paths.previous.assign(points_.size(), -1);
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  paths.cost_m[static_cast<std::size_t>(from)] = 0.0F;
  open.emplace(0.0F, from);
  while (!open.empty()) {
    const auto [cost_m, node] = open.top();
    open.pop();
    if (cost_m > paths.cost_m[static_cast<std::size_t>(node)]) continue;
    for (const Edge& edge : edges_[static_cast<std::size_t>(node)]) {
      float next_m = cost_m + edge.cost_m;
      if (!surcharge.empty()) {
        const float more = surcharge[static_cast<std::size_t>(node)] + surcharge[static_cast<std::size_t>(edge.to)];
        next_m += 0.5F * more * static_cast<float>((point(node) - point(edge.to)).norm());
      }
      if (next_m >= paths.cost_m[static_cast<std::size_t>(edge.to)]) continue;
      paths.cost_m[static_cast<std::size_t>(edge.to)] = next_m;
      paths.previous[static_cast<std::size_t>(edge.to)] = node;
      open.emplace(next_m, edge.to);
    }
  }
  return paths;
}

std::vector<Vector2d> MotionMap::way(const ShortestPaths& paths, int node, const Vector2d& start_in_map,
                                     const Vector2d& end_in_map) const {
  if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(node)])) return {};
  std::vector<Vector2d> nodes;
  for (int at = node; at >= 0; at = paths.previous[static_cast<std::size_t>(at)]) nodes.push_back(point(at));
  nodes.front() = end_in_map;
  if (nodes.size() > 1) {
    nodes.back() = start_in_map;
  } else if ((end_in_map - start_in_map).norm() > kSamePoint_m) {
    nodes.push_back(start_in_map);
  }
  std::reverse(nodes.begin(), nodes.end());
  std::vector<Vector2d> way{nodes.front()};
  for (std::size_t i = 0; i + 1 < nodes.size();) {
    std::size_t furthest = i + 1;
    double room_m = clearance_m(nodes[i], nodes[i + 1]);
    for (std::size_t j = i + 2; j < std::min(nodes.size(), i + kLookAhead); ++j) {
      room_m = std::min(room_m, clearance_m(nodes[j - 1], nodes[j]));
      if (clearance_m(nodes[i], nodes[j]) >= std::min(room_m, options_.preferred_clearance_m) - 1e-9) furthest = j;
    }
    way.push_back(nodes[furthest]);
    i = furthest;
  }
  return way;
}

}  // namespace tandem
