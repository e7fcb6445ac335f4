// Of planar_shape.hpp: what is not needed to evaluate rewards.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

Vector2d deepest_point(const Polygon& polygon) {
  constexpr int kSteps = 24;
  const Disc around = *enclosing_disc(polygon);
  Vector2d best = polygon.corners.front();
  double best_distance = 0.0;
  for (int row = -kSteps; row <= kSteps; ++row) {
    for (int column = -kSteps; column <= kSteps; ++column) {
      const Vector2d point = around.centre + around.radius_m * Vector2d{column, row} / kSteps;
      const double distance = signed_distance(polygon, point);
      if (distance < best_distance) {
        best_distance = distance;
        best = point;
      }
    }
  }
  return best;
}

struct InnerPoint {
  Vector2d operator()(const Disc& disc) const { return disc.centre; }
  Vector2d operator()(const Polygon& polygon) const { return deepest_point(polygon); }
  Vector2d operator()(const Corridor& corridor) const {
    std::size_t longest = 0;
    const auto length2 = [&](std::size_t i) { return (corridor.points[i + 1] - corridor.points[i]).squaredNorm(); };
    for (std::size_t i = 1; i + 1 < corridor.points.size(); ++i) {
      if (length2(i) > length2(longest)) longest = i;
    }
    return 0.5 * (corridor.points[longest] + corridor.points[longest + 1]);
  }
  Vector2d operator()(const HalfPlane& half_plane) const {
    constexpr double kBehind_m = 1.0;
    return half_plane.point - kBehind_m * half_plane.outward.normalized();
  }
};

struct Moved {
  Eigen::Rotation2Dd rotation;
  Vector2d origin;

  Vector2d point(const Vector2d& one) const { return origin + rotation * one; }
  std::vector<Vector2d> points(std::vector<Vector2d> all) const {
    for (Vector2d& one : all) one = point(one);
    return all;
  }
  PlanarShape operator()(const Disc& disc) const { return Disc{point(disc.centre), disc.radius_m}; }
  PlanarShape operator()(const Polygon& polygon) const { return Polygon{points(polygon.corners)}; }
  PlanarShape operator()(const Corridor& corridor) const {
    return Corridor{points(corridor.points), corridor.half_width_m};
  }
  PlanarShape operator()(const HalfPlane& half_plane) const {
    return HalfPlane{point(half_plane.point), rotation * half_plane.outward};
  }
};

}  // namespace

PlanarShape moved(const PlanarShape& shape, const Vector2d& origin, double heading_rad) {
  return std::visit(Moved{Eigen::Rotation2Dd{heading_rad}, origin}, shape);
}

Vector2d inner_point(const PlanarShape& shape) {
  return std::visit(InnerPoint{}, shape);
}

}  // namespace tandem
