#include "services/planner/core/srs/planar_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/planner/core/srs/segment_geometry.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

BoundaryVector vector_to_shape(const Disc& disc, const Vector2d& point) {
  return vector_from_capsule(disc.centre, disc.centre, disc.radius_m, point);
}

BoundaryVector vector_to_shape(const Polygon& polygon, const Vector2d& point) {
  const auto& corners = polygon.corners;
  const double area2 = twice_signed_area(corners);
  double nearest2 = std::numeric_limits<double>::infinity();
  Vector2d offset = Vector2d::Zero();
  Vector2d outward = Vector2d::UnitX();
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d& a = corners[i];
    const Vector2d& b = corners[(i + 1) % corners.size()];
    const Vector2d to_point = point - nearest_on_segment(a, b, point);
    if (to_point.squaredNorm() < nearest2) {
      nearest2 = to_point.squaredNorm();
      offset = to_point;
      outward = (area2 > 0.0 ? Vector2d{b.y() - a.y(), a.x() - b.x()} : Vector2d{a.y() - b.y(), b.x() - a.x()});
    }
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  const double distance = std::sqrt(nearest2);
  if (distance <= kOnBoundary_m) return {inside ? -distance : distance, outward.normalized()};
  return {inside ? -distance : distance, offset / distance};
}

BoundaryVector vector_to_shape(const Corridor& corridor, const Vector2d& point) {
  BoundaryVector nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < corridor.points.size(); ++i) {
    const auto one = vector_from_capsule(corridor.points[i], corridor.points[i + 1], corridor.half_width_m, point);
    if (one.distance < nearest.distance) nearest = one;
  }
  return nearest;
}

BoundaryVector vector_to_shape(const HalfPlane& half_plane, const Vector2d& point) {
  const Vector2d outward = half_plane.outward.normalized();
  const double distance = (point - half_plane.point).dot(outward);
  return {distance, distance < -kOnBoundary_m ? Vector2d{-outward} : outward};
}

bool add_crossings(const Disc& disc, double level_m, const Vector2d& from, const Vector2d& to,
                   std::vector<double>& shares) {
  append_circle_crossings(disc.centre, disc.radius_m + level_m, from, to, shares);
  return true;
}

bool add_crossings(const Polygon& polygon, double level_m, const Vector2d& from, const Vector2d& to,
                   std::vector<double>& shares) {
  constexpr double kCorner = 1e-12;  // a way through a corner meets at least one of its edges
  if (level_m != 0.0) return false;
  const auto& corners = polygon.corners;
  const Vector2d way = to - from;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vector2d edge = corners[i] - corners[j];
    const double parallel = cross(way, edge);
    if (parallel == 0.0) continue;
    const Vector2d offset = corners[j] - from;
    const double on_edge = cross(offset, way) / parallel;
    if (on_edge >= -kCorner && on_edge <= 1.0 + kCorner) append_share(cross(offset, edge) / parallel, shares);
  }
  return true;
}

bool add_crossings(const Corridor& corridor, double level_m, const Vector2d& from, const Vector2d& to,
                   std::vector<double>& shares) {
  const std::size_t before = shares.size();
  for (std::size_t i = 0; i + 1 < corridor.points.size(); ++i) {
    append_capsule_crossings(corridor.points[i], corridor.points[i + 1], corridor.half_width_m + level_m, from, to,
                             shares);
  }
  const auto is_elsewhere = [&](double share) {  // within another part of the corridor
    return vector_to_shape(corridor, from + share * (to - from)).distance < level_m - kOnBoundary_m;
  };
  shares.erase(std::remove_if(shares.begin() + static_cast<std::ptrdiff_t>(before), shares.end(), is_elsewhere),
               shares.end());
  return true;
}

bool add_crossings(const HalfPlane& half_plane, double level_m, const Vector2d& from, const Vector2d& to,
                   std::vector<double>& shares) {
  const Vector2d outward = half_plane.outward.normalized();
  const double start = (from - half_plane.point).dot(outward) - level_m;
  const double gain = (to - from).dot(outward);
  if (gain != 0.0) append_share(-start / gain, shares);
  return true;
}

Disc disc_around(const std::vector<Vector2d>& points, double margin_m) {
  Vector2d low = points.front();
  Vector2d high = points.front();
  for (const auto& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Disc disc{0.5 * (low + high), 0.0};
  for (const auto& point : points) disc.radius_m = std::max(disc.radius_m, (point - disc.centre).norm());
  disc.radius_m += margin_m;
  return disc;
}

std::optional<std::string> problem_of_shape(const Disc& disc) {
  if (!disc.centre.allFinite() || !std::isfinite(disc.radius_m)) return "its numbers must be finite";
  if (!(disc.radius_m > 0.0)) return "radius_m must be greater than 0";
  return std::nullopt;
}

std::optional<std::string> problem_of_shape(const Polygon& polygon) {
  const auto& corners = polygon.corners;
  const std::size_t count = corners.size();
  if (count < 3) return "a polygon needs at least three corners";
  if (!std::ranges::all_of(corners, [](const Vector2d& corner) { return corner.allFinite(); })) {
    return "its numbers must be finite";
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (corners[i] == corners[(i + 1) % count]) return "corner " + std::to_string(i) + " is the same as the next one";
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j + 1 == count);
      const auto& [a, b] = std::pair{corners[i], corners[i + 1]};
      const auto& [c, d] = std::pair{corners[j], corners[(j + 1) % count]};
      if (neighbours ? fold_back(a, b, c, d) : segments_meet(a, b, c, d)) {
        return "the polygon intersects itself: edges " + std::to_string(i) + " and " + std::to_string(j);
      }
    }
  }
  if (std::abs(twice_signed_area(corners)) <= 0.0) return "the polygon has no area";
  return std::nullopt;
}

std::optional<std::string> problem_of_shape(const Corridor& corridor) {
  if (corridor.points.size() < 2) return "a corridor needs at least two points";
  if (!std::ranges::all_of(corridor.points, [](const Vector2d& point) { return point.allFinite(); }) ||
      !std::isfinite(corridor.half_width_m)) {
    return "its numbers must be finite";
  }
  if (!(corridor.half_width_m > 0.0)) return "half_width_m must be greater than 0";
  for (std::size_t i = 0; i + 1 < corridor.points.size(); ++i) {
    if (corridor.points[i] == corridor.points[i + 1]) {
      return "a part of the corridor has no length: point " + std::to_string(i) + " is the same as the next one";
    }
  }
  return std::nullopt;
}

std::optional<std::string> problem_of_shape(const HalfPlane& half_plane) {
  if (!half_plane.point.allFinite() || !half_plane.outward.allFinite()) return "its numbers must be finite";
  if (!(half_plane.outward.norm() > 0.0)) return "outward must have a length";
  return std::nullopt;
}

}  // namespace

BoundaryVector vector_to(const PlanarShape& shape, const Vector2d& point) {
  return std::visit([&](const auto& one) { return vector_to_shape(one, point); }, shape);
}

double signed_distance(const PlanarShape& shape, const Vector2d& point) {
  return vector_to(shape, point).distance;
}

bool contains(const PlanarShape& shape, const Vector2d& point) {
  return signed_distance(shape, point) <= kOnBoundary_m;
}

bool append_level_crossings(const PlanarShape& shape, double level_m, const Vector2d& from, const Vector2d& to,
                            std::vector<double>& shares) {
  return std::visit([&](const auto& one) { return add_crossings(one, level_m, from, to, shares); }, shape);
}

std::optional<Disc> enclosing_disc(const PlanarShape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return *disc;
  if (const auto* polygon = std::get_if<Polygon>(&shape)) return disc_around(polygon->corners, 0.0);
  if (const auto* corridor = std::get_if<Corridor>(&shape)) {
    return disc_around(corridor->points, corridor->half_width_m);
  }
  return std::nullopt;
}

std::optional<std::string> problem_of(const PlanarShape& shape) {
  return std::visit([](const auto& one) { return problem_of_shape(one); }, shape);
}

}  // namespace tandem
