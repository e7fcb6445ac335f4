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
constexpr double kTiny_m = 1e-6;
constexpr double kSlack_m = 0.02;       ///< of clearance, for what lies between the map's cells
constexpr std::size_t kLookAhead = 80;  ///< nodes over which a corner may be cut

}  // namespace

MotionMap::MotionMap(const OccupancyGrid& map, const MotionOptions& options, const std::vector<BlockedDisc>& blocked)
    : options_(options),
      clearance_(map, kClearanceLimit_m, Obstacles::OccupiedOrUnknown),
      blocked_(blocked),
      map_from_lattice_(map.map_from_grid()) {
  add_nodes(map);
  add_edges();
}

int MotionMap::node_at(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return -1;
  return node_of_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
}

void MotionMap::add_nodes(const OccupancyGrid& map) {
  const int side = std::max(1, static_cast<int>(std::lround(options_.node_spacing_m / map.resolution_m())));
  spacing_m_ = side * map.resolution_m();
  columns_ = (map.width() + side - 1) / side;
  rows_ = (map.height() + side - 1) / side;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      node_of_.push_back(-1);
      // The middle of the block if it is in the open, else its place with the most room.
      CellIndex best{column * side + side / 2, row * side + side / 2};
      if (!map.contains(best) || clearance_.at(best) < options_.preferred_clearance_m) {
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
      if (!map.is_free(best) || clearance_.at(best) < options_.radius_m) continue;
      const Vector2d point = map.centre_in_map(best);
      if (is_blocked(point, point)) continue;
      node_of_.back() = size();
      points_.push_back(point);
    }
  }
}

void MotionMap::add_edges() {
  constexpr CellIndex kNeighbours[] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}};
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int node = node_at(column, row);
      if (node < 0) continue;
      first_edge_.push_back(static_cast<std::uint32_t>(edges_.size()));
      for (const auto& [right, up] : kNeighbours) {
        const int other = node_at(column + right, row + up);
        if (other < 0) continue;
        const double room_m = clearance_m(point(node), point(other));
        if (room_m < options_.radius_m - kSlack_m) continue;
        const double shortfall =
            std::max(0.0, options_.preferred_clearance_m - room_m) / options_.preferred_clearance_m;
        const double cost_m = (point(node) - point(other)).norm() * (1.0 + options_.clearance_weight * shortfall);
        edges_.push_back({other, static_cast<float>(cost_m)});
      }
    }
  }
  first_edge_.push_back(static_cast<std::uint32_t>(edges_.size()));
}

bool MotionMap::is_blocked(const Vector2d& from, const Vector2d& to) const {
  return std::ranges::any_of(blocked_, [&](const BlockedDisc& disc) {
    const double length2 = (to - from).squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp((disc.centre_in_map - from).dot(to - from) / length2, 0.0, 1.0) : 0.0;
    return (from + share * (to - from) - disc.centre_in_map).norm() < disc.radius_m;
  });
}

double MotionMap::clearance_m(const Vector2d& from, const Vector2d& to) const {
  if (is_blocked(from, to)) return 0.0;
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSampling_m)));
  double least_m = kClearanceLimit_m;
  for (int i = 0; i <= pieces; ++i) {
    least_m = std::min(least_m, static_cast<double>(clearance_.nearest(from + (to - from) * i / pieces)));
  }
  return least_m;
}

/// Whether clearance_m() is at least `room_m`; where there is more, steps are longer.
bool MotionMap::has_clearance(const Vector2d& from, const Vector2d& to, double room_m) const {
  if (is_blocked(from, to)) return false;
  const double length_m = (to - from).norm();
  for (double at_m = 0.0;;) {
    const double share = length_m > 0.0 ? std::min(1.0, at_m / length_m) : 1.0;
    const double here_m = clearance_.nearest(from + share * (to - from));
    if (here_m < room_m) return false;
    if (at_m >= length_m) return true;
    at_m = std::min(length_m, at_m + std::max(kSampling_m, here_m - room_m));
  }
}

std::optional<int> MotionMap::nearest_node(const Vector2d& point_in_map, double reach_m) const {
  const Vector2d in_lattice = (inverse(map_from_lattice_) * point_in_map) / spacing_m_;
  // Around the block of the lattice that is nearest: from there, nothing in it is farther than from the point itself.
  const auto column = static_cast<int>(std::clamp(std::floor(in_lattice.x()), 0.0, std::max(0.0, columns_ - 1.0)));
  const auto row = static_cast<int>(std::clamp(std::floor(in_lattice.y()), 0.0, std::max(0.0, rows_ - 1.0)));
  const double rings = std::min(std::ceil(reach_m / spacing_m_) + 1.0, static_cast<double>(std::max(columns_, rows_)));
  const auto last_ring = static_cast<int>(rings);
  std::optional<int> nearest;
  double nearest_m = reach_m;
  const auto consider = [&](int x, int y) {
    const int node = node_at(x, y);
    if (node < 0) return;
    const double distance_m = (point(node) - point_in_map).norm();
    if (distance_m > nearest_m || (nearest && (distance_m == nearest_m) && node >= *nearest)) return;
    nearest_m = distance_m;
    nearest = node;
  };
  // Ring by ring; what lies in a ring is at least that many blocks away, less one.
  for (int ring = 0; ring <= last_ring && (!nearest || (ring - 1) * spacing_m_ <= nearest_m); ++ring) {
    for (int x = column - ring; x <= column + ring; ++x) {
      consider(x, row - ring);
      if (ring > 0) consider(x, row + ring);
    }
    for (int y = row - ring + 1; y < row + ring; ++y) {
      consider(column - ring, y);
      consider(column + ring, y);
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
    for (const Edge& edge : edges(node)) {
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
  std::vector<int> nodes;
  for (int at = node; at >= 0; at = paths.previous[static_cast<std::size_t>(at)]) nodes.push_back(at);
  std::reverse(nodes.begin(), nodes.end());
  return way(nodes, start_in_map, end_in_map);
}

std::vector<Vector2d> MotionMap::way(std::span<const int> nodes, const Vector2d& start_in_map,
                                     const Vector2d& end_in_map) const {
  std::vector<Vector2d> points;
  for (const int node : nodes) points.push_back(point(node));
  points.front() = start_in_map;
  if (points.size() > 1) {
    points.back() = end_in_map;
  } else if ((end_in_map - start_in_map).norm() > kSamePoint_m) {
    points.push_back(end_in_map);
  }
  std::vector<double> rooms_m(points.size(), kClearanceLimit_m);  // to the next point
  for (std::size_t i = 0; i + 1 < points.size(); ++i) rooms_m[i] = clearance_m(points[i], points[i + 1]);
  std::vector<double> least_m(points.size());  // from point i to each further one
  std::vector<Vector2d> way{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    const std::size_t last = std::min(points.size() - 1, i + kLookAhead);
    least_m[i] = kClearanceLimit_m;
    for (std::size_t j = i + 1; j <= last; ++j) least_m[j] = std::min(least_m[j - 1], rooms_m[j - 1]);
    std::size_t furthest = i + 1;
    for (std::size_t j = last; j > i + 1; --j) {
      if (!has_clearance(points[i], points[j], std::min(least_m[j], options_.preferred_clearance_m) - kTiny_m))
        continue;
      furthest = j;
      break;
    }
    way.push_back(points[furthest]);
    i = furthest;
  }
  return way;
}

}  // namespace tandem
