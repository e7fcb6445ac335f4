#include "services/planner/core/tasks/travel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kSamePlace_m = 1e-6;
constexpr double kSlack_m = 0.03;  ///< of clearance, as the lattice of a MotionMap has it
/// A second is worth at least these shares of the worst hazard: a detour may be that many times as long.
constexpr double kLeastWorthOfTime[] = {0.1, 0.01};

bool is_same(const TravelWay& a, const TravelWay& b) {
  return std::abs(a.length_m - b.length_m) < 1e-3 && std::abs(a.hazard - b.hazard) < 1e-3;
}

}  // namespace

Travel::Travel(const MotionMap* motion, const Hazards* hazards, const Searcher& searcher, double cost_of_time_per_s)
    : motion_(motion),
      hazards_(hazards),
      radius_m_(searcher.radius_m),
      preferred_clearance_m_(searcher.preferred_clearance_m) {
  surcharges_s_.push_back(0.0);
  if (hazards->empty()) return;
  for (const double share : kLeastWorthOfTime) {
    const double surcharge_s = 1.0 / std::max(cost_of_time_per_s, share * hazards->peak_per_s());
    if (surcharge_s > surcharges_s_.back()) surcharges_s_.push_back(surcharge_s);
  }
}

std::optional<int> Travel::place_at(const Vector2d& point_in_map, double reach_m) {
  Vector2d standpoint = point_in_map;
  int node = -1;
  if (motion_ != nullptr) {
    const auto nearest = motion_->nearest_node(point_in_map, std::max(reach_m, 1.0));
    if (!nearest) return std::nullopt;
    node = *nearest;
    const bool stands_there = motion_->clearance_m(point_in_map, motion_->point(node)) >= radius_m_ - kSlack_m;
    if (!stands_there) {
      standpoint = motion_->point(node);
      if ((standpoint - point_in_map).norm() > reach_m) return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if ((points_[i] - standpoint).norm() < kSamePlace_m) return static_cast<int>(i);
  }
  points_.push_back(standpoint);
  nodes_.push_back(node);
  return static_cast<int>(points_.size()) - 1;
}

const std::vector<TravelWay>& Travel::ways(int from, int to) {
  const auto [found, is_new] = ways_.try_emplace({from, to});
  if (!is_new) return found->second;
  std::vector<TravelWay> all;
  for (const double surcharge_s : surcharges_s_) {
    auto way = motion_ == nullptr ? way_on_plane(from, to, surcharge_s) : way_in_room(from, to, surcharge_s);
    if (!way || std::ranges::any_of(all, [&](const TravelWay& other) { return is_same(*way, other); })) continue;
    all.push_back(std::move(*way));
    if (all.front().hazard == 0.0) break;
  }
  found->second = std::move(all);
  return found->second;
}

bool Travel::is_clear(const Vector2d& from, const Vector2d& to) const {
  return motion_ == nullptr || motion_->clearance_m(from, to) >= radius_m_ - kSlack_m;
}

TravelWay Travel::way_over(std::vector<Vector2d> points) const {
  TravelWay way;
  for (std::size_t i = 1; i < points.size(); ++i) {
    way.length_m += (points[i] - points[i - 1]).norm();
    way.hazard += hazards_->along(points[i - 1], points[i]);
  }
  way.points_in_map = std::move(points);
  return way;
}

/// Dijkstra over start, end and the points around hazards.
std::optional<TravelWay> Travel::way_on_plane(int from, int to, double surcharge_s) const {
  if (surcharge_s == 0.0) return way_over({point(from), point(to)});
  std::vector<Vector2d> corners{point(from), point(to)};
  corners.insert(corners.end(), hazards_->detour_points().begin(), hazards_->detour_points().end());
  const std::size_t count = corners.size();
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(count, 0);
  std::vector<bool> settled(count, false);
  cost[0] = 0.0;
  while (true) {
    std::size_t at = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (!settled[i] && std::isfinite(cost[i]) && (at == count || cost[i] < cost[at])) at = i;
    }
    if (at == count || at == 1) break;
    settled[at] = true;
    for (std::size_t i = 1; i < count; ++i) {
      if (settled[i]) continue;
      const double length_m = (corners[i] - corners[at]).norm();
      if (cost[at] + length_m >= cost[i]) continue;
      const double next = cost[at] + length_m + surcharge_s * hazards_->along(corners[at], corners[i]);
      if (next >= cost[i]) continue;
      cost[i] = next;
      previous[i] = at;
    }
  }
  std::vector<Vector2d> points{corners[1]};
  for (std::size_t at = 1; at != 0;) {
    at = previous[at];
    points.push_back(corners[at]);
  }
  std::reverse(points.begin(), points.end());
  return way_over(std::move(points));
}

/// Along the lattice, corners cut wherever that is as wide and costs no more.
std::optional<TravelWay> Travel::way_in_room(int from, int to, double surcharge_s) {
  const auto number = static_cast<int>(std::ranges::find(surcharges_s_, surcharge_s) - surcharges_s_.begin());
  const auto [found, is_new] = paths_.try_emplace({from, number});
  if (is_new) {
    std::vector<float> surcharge;
    if (surcharge_s > 0.0) {
      for (int node = 0; node < motion_->size(); ++node) {
        surcharge.push_back(static_cast<float>(surcharge_s * hazards_->cost_per_s(motion_->point(node))));
      }
    }
    found->second = motion_->shortest_paths(nodes_[static_cast<std::size_t>(from)], surcharge);
  }
  const ShortestPaths& paths = found->second;
  const int end = nodes_[static_cast<std::size_t>(to)];
  if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(end)])) return std::nullopt;
  std::vector<Vector2d> nodes{point(to)};
  for (int at = end; at >= 0; at = paths.previous[static_cast<std::size_t>(at)]) nodes.push_back(motion_->point(at));
  nodes.push_back(point(from));
  std::reverse(nodes.begin(), nodes.end());
  const auto cost = [&](const Vector2d& a, const Vector2d& b) {
    return (b - a).norm() + (surcharge_s > 0.0 ? surcharge_s * hazards_->along(a, b) : 0.0);
  };
  std::vector<double> room_m(nodes.size(), 0.0);
  for (std::size_t i = 1; i < nodes.size(); ++i) room_m[i] = motion_->clearance_m(nodes[i - 1], nodes[i]);
  // The cheapest chain of straight, clear pieces over the nodes, by dynamic programming from the end.
  const std::size_t count = nodes.size();
  std::vector<double> rest(count, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> next(count, 0);
  rest[count - 1] = 0.0;
  for (std::size_t i = count - 1; i-- > 0;) {
    std::vector<double> wanted_m(count, preferred_clearance_m_);  // no less room than along the nodes
    for (std::size_t j = i + 1; j < count; ++j) wanted_m[j] = std::min(wanted_m[j - 1], room_m[j]);
    for (std::size_t j = count - 1; j > i; --j) {
      if ((nodes[j] - nodes[i]).norm() + rest[j] >= rest[i]) continue;
      if (j > i + 1 && motion_->clearance_m(nodes[i], nodes[j]) < wanted_m[j] - 1e-9) continue;
      const double sum = cost(nodes[i], nodes[j]) + rest[j];
      if (sum >= rest[i]) continue;
      rest[i] = sum;
      next[i] = j;
    }
  }
  std::vector<Vector2d> points{nodes.front()};
  for (std::size_t i = 0; i + 1 < count; i = next[i]) points.push_back(nodes[next[i]]);
  return way_over(std::move(points));
}

}  // namespace tandem
