#include "services/planner/core/srs/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kOnBoundary_m = 1e-12;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double distance_to_edge(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  const Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (a + share * edge - point).norm();
}

double signed_distance_to(const Disc& disc, const Vector2d& point) {
  return (point - disc.centre_in_map).norm() - disc.radius_m;
}

double signed_distance_to(const Polygon& polygon, const Vector2d& point) {
  const auto& corners = polygon.corners_in_map;
  double distance = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vector2d& a = corners[i];
    const Vector2d& b = corners[j];
    distance = std::min(distance, distance_to_edge(a, b, point));
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside ? -distance : distance;
}

void add_crossings(const Disc& disc, const Vector2d& from, const Vector2d& to, std::vector<double>& shares) {
  const Vector2d way = to - from;
  const Vector2d offset = from - disc.centre_in_map;
  const double a = way.squaredNorm();
  const double half_b = offset.dot(way);
  const double c = offset.squaredNorm() - disc.radius_m * disc.radius_m;
  const double discriminant = half_b * half_b - a * c;
  if (a == 0.0 || discriminant < 0.0) return;
  const double root = std::sqrt(discriminant);
  shares.push_back((-half_b - root) / a);
  shares.push_back((-half_b + root) / a);
}

void add_crossings(const Polygon& polygon, const Vector2d& from, const Vector2d& to, std::vector<double>& shares) {
  const auto& corners = polygon.corners_in_map;
  const Vector2d way = to - from;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vector2d edge = corners[i] - corners[j];
    const double parallel = cross(way, edge);
    if (parallel == 0.0) continue;
    const Vector2d offset = corners[j] - from;
    const double on_edge = cross(offset, way) / parallel;
    if (on_edge >= 0.0 && on_edge <= 1.0) shares.push_back(cross(offset, edge) / parallel);
  }
}

}  // namespace

double signed_distance(const Boundary& boundary, const Vector2d& point_in_map) {
  return std::visit([&](const auto& shape) { return signed_distance_to(shape, point_in_map); }, boundary);
}

bool contains(const Boundary& boundary, const Vector2d& point_in_map) {
  return signed_distance(boundary, point_in_map) <= kOnBoundary_m;
}

std::vector<double> crossings(const Boundary& boundary, const Vector2d& from_in_map, const Vector2d& to_in_map) {
  std::vector<double> shares;
  std::visit([&](const auto& shape) { add_crossings(shape, from_in_map, to_in_map, shares); }, boundary);
  std::erase_if(shares, [](double share) { return share < 0.0 || share > 1.0; });
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace tandem
