#include "services/planner/core/srs/segment_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

using Eigen::Vector2d;

/// A way that is inside for less than two micrometres touches and does not cross: where it only just touches, rounding
/// would decide.
constexpr double kTouch_m2 = 1e-12;

/// On the segment, given that it is on its line.
bool lies_between(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  return (point - a).dot(point - b) <= 0.0;
}

}  // namespace

double twice_signed_area(const std::vector<Vector2d>& corners) {
  double area2 = 0.0;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) area2 += cross(corners[j], corners[i]);
  return area2;
}

Vector2d nearest_on_segment(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  const Vector2d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return a + share * edge;
}

BoundaryVector vector_from_capsule(const Vector2d& a, const Vector2d& b, double radius_m, const Vector2d& point) {
  const Vector2d offset = point - nearest_on_segment(a, b, point);
  const double from_line = offset.norm();
  const double distance = from_line - radius_m;
  Vector2d away = Vector2d::UnitX();
  if (from_line > kOnBoundary_m) {
    away = offset / from_line;
  } else if (a != b) {
    away = Vector2d{a.y() - b.y(), b.x() - a.x()}.normalized();  // to the left of the way from a to b
  }
  return {distance, distance < -kOnBoundary_m ? Vector2d{-away} : away};
}

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (((c_side > 0.0) != (d_side > 0.0)) && c_side != 0.0 && d_side != 0.0 && ((a_side > 0.0) != (b_side > 0.0)) &&
      a_side != 0.0 && b_side != 0.0) {
    return true;
  }
  return (c_side == 0.0 && lies_between(a, b, c)) || (d_side == 0.0 && lies_between(a, b, d)) ||
         (a_side == 0.0 && lies_between(c, d, a)) || (b_side == 0.0 && lies_between(c, d, b));
}

bool fold_back(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if (cross(b - a, d - c) != 0.0) return false;
  return (b == c && (a - b).dot(d - b) > 0.0) || (d == a && (b - a).dot(c - a) > 0.0);
}

void append_share(double share, std::vector<double>& shares) {
  if (share >= 0.0 && share <= 1.0) shares.push_back(share);
}

void append_quadratic_roots(double a, double half_b, double c, std::vector<double>& shares) {
  const double discriminant = half_b * half_b - a * c;
  if (discriminant <= kTouch_m2 * a) return;
  const double root = std::sqrt(discriminant);
  // The root of the smaller magnitude comes from the other one: nothing is cancelled.
  const double larger = -(half_b + std::copysign(root, half_b));
  append_share(larger / a, shares);
  if (larger != 0.0) append_share(c / larger, shares);
}

void append_circle_crossings(const Vector2d& centre, double radius_m, const Vector2d& from, const Vector2d& to,
                             std::vector<double>& shares) {
  if (radius_m < 0.0) return;
  const Vector2d way = to - from;
  const Vector2d offset = from - centre;
  append_quadratic_roots(way.squaredNorm(), offset.dot(way), offset.squaredNorm() - radius_m * radius_m, shares);
}

void append_capsule_crossings(const Vector2d& a, const Vector2d& b, double radius_m, const Vector2d& from,
                              const Vector2d& to, std::vector<double>& shares) {
  if (radius_m < 0.0) return;
  const std::size_t before = shares.size();
  append_circle_crossings(a, radius_m, from, to, shares);
  append_circle_crossings(b, radius_m, from, to, shares);
  if (a != b) {
    const Vector2d along = (b - a).normalized();
    const double start = cross(along, from - a);
    const double gain = cross(along, to - from);
    if (gain != 0.0) {
      append_share((radius_m - start) / gain, shares);
      append_share((-radius_m - start) / gain, shares);
    }
  }
  const auto is_elsewhere = [&](double share) {
    const Vector2d point = from + share * (to - from);
    return std::abs((point - nearest_on_segment(a, b, point)).norm() - radius_m) > kOnBoundary_m;
  };
  shares.erase(std::remove_if(shares.begin() + static_cast<std::ptrdiff_t>(before), shares.end(), is_elsewhere),
               shares.end());
}

}  // namespace tandem
