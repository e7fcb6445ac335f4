#include "services/simulator/core/place.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace tandem::simulator {
namespace {

constexpr double kLatticeStep_m = 0.25;
constexpr double kFarthestClearance_m = 5.0;

/// The nodes of a walk: points every kLatticeStep_m over the whole map.
struct Lattice {
  int columns;
  int rows;
  Pose2 map_from_grid;

  explicit Lattice(const OccupancyGrid& map)
      : columns(static_cast<int>(map.width() * map.resolution_m() / kLatticeStep_m) + 1),
        rows(static_cast<int>(map.height() * map.resolution_m() / kLatticeStep_m) + 1),
        map_from_grid(map.map_from_grid()) {}

  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  [[nodiscard]] int node(int column, int row) const { return row * columns + column; }
  [[nodiscard]] int node_at(const Eigen::Vector2d& point_in_map) const {
    const Eigen::Vector2d p = inverse(map_from_grid) * point_in_map / kLatticeStep_m;
    return node(std::clamp(static_cast<int>(std::lround(p.x())), 0, columns - 1),
                std::clamp(static_cast<int>(std::lround(p.y())), 0, rows - 1));
  }
  [[nodiscard]] Eigen::Vector2d point(int node) const {
    return map_from_grid * Eigen::Vector2d{(node % columns) * kLatticeStep_m, (node / columns) * kLatticeStep_m};
  }
};

/// Leaves out every corner that a straight line can skip.
std::vector<Eigen::Vector2d> shortened(const Place& place, const std::vector<Eigen::Vector2d>& walk, double radius_m) {
  std::vector<Eigen::Vector2d> corners{walk.front()};
  std::size_t here = 0;
  while (here + 1 < walk.size()) {
    std::size_t next = walk.size() - 1;
    while (next > here + 1 && !place.has_way(walk[here], walk[next], radius_m)) --next;
    corners.push_back(walk[next]);
    here = next;
  }
  return corners;
}

}  // namespace

Place::Place(OccupancyGrid map)
    : map_(std::move(map)), clearance_(map_, kFarthestClearance_m, Obstacles::OccupiedOrUnknown) {}

double Place::clearance_m(const Eigen::Vector2d& point_in_map) const {
  const CellIndex cell = map_.cell_at(point_in_map);
  if (!map_.is_free(cell)) return 0.0;
  // The field tells centre to centre: the wall's own half cell is nearer.
  return std::max(0.0, clearance_.distance_m(point_in_map) - 0.5 * map_.resolution_m());
}

bool Place::has_way(const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map, double radius_m) const {
  const double length = (to_in_map - from_in_map).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / (0.5 * kLatticeStep_m))));
  for (int i = 0; i <= steps; ++i) {
    if (!has_room(from_in_map + (to_in_map - from_in_map) * (static_cast<double>(i) / steps), radius_m)) return false;
  }
  return true;
}

std::vector<Eigen::Vector2d> Place::largest_ground(double radius_m) const {
  std::vector<int> component(map_.cells().size(), 0);  // 0: not yet seen, -1: no room
  std::vector<CellIndex> largest;
  int count = 0;
  for (int row = 0; row < map_.height(); ++row) {
    for (int column = 0; column < map_.width(); ++column) {
      if (component[map_.offset({column, row})] != 0) continue;
      ++count;
      std::vector<CellIndex> members;
      std::vector<CellIndex> open{{column, row}};
      while (!open.empty()) {
        const CellIndex cell = open.back();
        open.pop_back();
        if (!map_.contains(cell) || component[map_.offset(cell)] != 0) continue;
        const bool room = has_room(map_.centre_in_map(cell), radius_m);
        component[map_.offset(cell)] = room ? count : -1;
        if (!room) continue;
        members.push_back(cell);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          open.push_back({cell.column + dx, cell.row + dy});
        }
      }
      if (members.size() > largest.size()) largest = std::move(members);
    }
  }
  std::sort(largest.begin(), largest.end(),
            [](CellIndex a, CellIndex b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  std::vector<Eigen::Vector2d> centres;
  centres.reserve(largest.size());
  for (const auto& cell : largest) centres.push_back(map_.centre_in_map(cell));
  return centres;
}

std::vector<Eigen::Vector2d> shortest_walk(const Place& place, const Eigen::Vector2d& from_in_map,
                                           const Eigen::Vector2d& to_in_map, double radius_m) {
  if (place.has_way(from_in_map, to_in_map, radius_m)) return {from_in_map, to_in_map};
  const Lattice lattice{place.map()};
  const int start = lattice.node_at(from_in_map);
  const int goal = lattice.node_at(to_in_map);
  const auto nodes = static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows);
  std::vector<double> cost(nodes, std::numeric_limits<double>::infinity());
  std::vector<int> came_from(nodes, -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto index = [](int node) { return static_cast<std::size_t>(node); };
  cost[index(start)] = 0.0;
  open.push({0.0, start});
  while (!open.empty()) {
    const auto [estimate, node] = open.top();
    open.pop();
    if (node == goal) break;
    const Eigen::Vector2d here = lattice.point(node);
    if (estimate > cost[index(node)] + (lattice.point(goal) - here).norm() + 1e-9) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int column = node % lattice.columns + dx;
        const int row = node / lattice.columns + dy;
        if ((dx == 0 && dy == 0) || !lattice.contains(column, row)) continue;
        const int next = lattice.node(column, row);
        const Eigen::Vector2d there = lattice.point(next);
        if (next != goal && !place.has_room(there, radius_m)) continue;
        const double reached = cost[index(node)] + (there - here).norm();
        if (reached >= cost[index(next)]) continue;
        cost[index(next)] = reached;
        came_from[index(next)] = node;
        open.push({reached + (lattice.point(goal) - there).norm(), next});
      }
    }
  }
  if (came_from[index(goal)] < 0) return {};
  std::vector<Eigen::Vector2d> walk{to_in_map};
  for (int node = goal; node >= 0; node = came_from[index(node)]) walk.push_back(lattice.point(node));
  walk.push_back(from_in_map);
  std::reverse(walk.begin(), walk.end());
  return shortened(place, walk, radius_m);
}

}  // namespace tandem::simulator
