#include "services/planner/core/tasks/stations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/common/pose2.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kInset_m = 0.05;  ///< stations at an edge lie so far inside
constexpr double kLarge_m = 0.75;  ///< larger ones have stations at their edge
constexpr int kRingPoints = 12;
constexpr double kAlongEdge_m = 2.0;  ///< between stations along the edge of a polygon, or along a corridor

/// Evenly spread points of a line, ends included.
void add_along(const Vector2d& from, const Vector2d& to, std::vector<Vector2d>& points) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kAlongEdge_m)));
  for (int i = 0; i <= pieces; ++i) points.push_back(from + (to - from) * i / pieces);
}

std::vector<Vector2d> points_in(const Disc& disc, const Vector2d&) {
  std::vector<Vector2d> points{disc.centre};
  if (disc.radius_m <= kLarge_m) return points;
  for (int i = 0; i < kRingPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRingPoints;
    points.push_back(disc.centre + (disc.radius_m - kInset_m) * Vector2d{std::cos(angle), std::sin(angle)});
  }
  return points;
}

std::vector<Vector2d> points_in(const Polygon& polygon, const Vector2d&) {
  Vector2d middle = Vector2d::Zero();
  for (const auto& corner : polygon.corners) middle += corner / static_cast<double>(polygon.corners.size());
  std::vector<Vector2d> points{middle};
  std::vector<Vector2d> edge;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    add_along(polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()], edge);
  }
  for (const auto& point : edge) {
    const BoundaryVector near = vector_to(PlanarShape{polygon}, point);
    points.push_back(point - (near.distance + kInset_m) * near.direction);
  }
  std::erase_if(points, [&](const Vector2d& point) { return !contains(PlanarShape{polygon}, point); });
  return points;
}

std::vector<Vector2d> points_in(const Corridor& corridor, const Vector2d&) {
  std::vector<Vector2d> points;
  for (std::size_t i = 1; i < corridor.points.size(); ++i) {
    add_along(corridor.points[i - 1], corridor.points[i], points);
  }
  return points;
}

std::vector<Vector2d> points_in(const HalfPlane& half, const Vector2d& seen_from) {
  const Vector2d outward = half.outward.normalized();
  const double out_m = (seen_from - half.point).dot(outward);
  return {seen_from - std::max(0.0, out_m + kInset_m) * outward};
}

Vector2d a_point_in(const PlanarShape& shape, const Vector2d& seen_from) {
  return std::visit([&](const auto& one) { return points_in(one, seen_from).front(); }, shape);
}

}  // namespace

std::vector<Vector2d> stations_of(const ResolvedBoundary& boundary, double altitude_m,
                                  const Vector2d& seen_from_in_map) {
  if (const auto* placed = std::get_if<PlacedShape>(&boundary); placed != nullptr && placed->owner < 0) {
    return std::visit([&](const auto& shape) { return points_in(shape, seen_from_in_map); }, placed->shape);
  }
  if (const auto* sphere = std::get_if<Sphere>(&boundary)) {
    const double up_m = altitude_m - sphere->centre_in_map.z();
    if (std::abs(up_m) > sphere->radius_m) return {};
    const double radius_m = std::sqrt(sphere->radius_m * sphere->radius_m - up_m * up_m);
    return points_in(Disc{sphere->centre_in_map.head<2>(), radius_m}, seen_from_in_map);
  }
  if (const auto* box = std::get_if<Box>(&boundary)) {
    if (altitude_m < box->low_in_map.z() || altitude_m > box->high_in_map.z()) return {};
    const Vector2d low = box->low_in_map.head<2>();
    const Vector2d high = box->high_in_map.head<2>();
    return points_in(Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}}, seen_from_in_map);
  }
  return {};
}

Vector2d moving_station(const ResolvedBoundary& boundary, const JointMove& joint) {
  if (const auto* corridor = std::get_if<MovingCorridor>(&boundary)) {
    const auto at = [&](const ResolvedAnchor& anchor) {
      return anchor.agent < 0 ? anchor.point_in_map : joint.moves[static_cast<std::size_t>(anchor.agent)].from_in_map;
    };
    return 0.5 * (at(corridor->from) + at(corridor->to));
  }
  const auto& placed = std::get<PlacedShape>(boundary);
  const AgentMove& owner = joint.moves[static_cast<std::size_t>(placed.owner)];
  const Pose2 map_from_owner{owner.from_in_map.x(), owner.from_in_map.y(), owner.from_heading_rad};
  return map_from_owner * a_point_in(placed.shape, Vector2d::Zero());
}

bool is_moving(const ResolvedBoundary& boundary) {
  const auto* placed = std::get_if<PlacedShape>(&boundary);
  return std::holds_alternative<MovingCorridor>(boundary) || (placed != nullptr && placed->owner >= 0);
}

bool moves_with(const ResolvedBoundary& boundary, std::size_t agent) {
  const int number = static_cast<int>(agent);
  if (const auto* corridor = std::get_if<MovingCorridor>(&boundary)) {
    return corridor->from.agent == number || corridor->to.agent == number;
  }
  const auto* placed = std::get_if<PlacedShape>(&boundary);
  return placed != nullptr && placed->owner == number;
}

}  // namespace tandem
