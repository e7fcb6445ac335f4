#include "services/navigator/core/swept_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tandem::navigator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStraight = 1e-4;  ///< A flatter curvature [1/m] is a straight line.

/// Turn [rad] in [0, 2 pi) from direction `from` to `to`, clockwise if `clockwise`.
double turn(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool clockwise) {
  const double cross = from.x() * to.y() - from.y() * to.x();
  const double angle = std::atan2(clockwise ? -cross : cross, from.dot(to));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

}  // namespace

double Hull::circumscribed_radius_m() const {
  return 0.5 * std::hypot(length_m, width_m);
}

double distance_to(const Hull& hull, const Eigen::Vector2d& point_in_base) {
  const double ahead = std::max(0.0, std::abs(point_in_base.x()) - 0.5 * hull.length_m);
  const double aside = std::max(0.0, std::abs(point_in_base.y()) - 0.5 * hull.width_m);
  return std::hypot(ahead, aside);
}

double way_to_contact(const Hull& hull, double curvature, const Eigen::Vector2d& point_in_base) {
  const double front = 0.5 * hull.length_m;
  const double side = 0.5 * hull.width_m;
  const Eigen::Vector2d& p = point_in_base;
  if (std::abs(p.x()) <= front && std::abs(p.y()) <= side) return 0.0;
  if (std::abs(curvature) < kStraight) return std::abs(p.y()) <= side && p.x() > 0.0 ? p.x() - front : kInfinity;

  const Eigen::Vector2d centre{0.0, 1.0 / curvature};
  const Eigen::Vector2d ray = p - centre;
  const double radius = ray.norm();
  double least_turn = kInfinity;
  const auto touch = [&](double x, double y) {
    if (std::abs(x) > front + 1e-9 || std::abs(y) > side + 1e-9) return;
    least_turn = std::min(least_turn, turn(ray, Eigen::Vector2d{x, y} - centre, curvature > 0.0));
  };
  for (const double x : {front, -front}) {  // circle of the point and the edges ahead and behind
    const double square = radius * radius - x * x;
    if (square < 0.0) continue;
    const double root = std::sqrt(square);
    touch(x, centre.y() + root);
    touch(x, centre.y() - root);
  }
  for (const double y : {side, -side}) {
    const double square = radius * radius - (y - centre.y()) * (y - centre.y());
    if (square < 0.0) continue;
    const double root = std::sqrt(square);
    touch(root, y);
    touch(-root, y);
  }
  return least_turn / std::abs(curvature);
}

FreeWay free_way(const Hull& hull, double margin_m, double curvature,
                 const std::vector<Eigen::Vector2d>& points_in_base) {
  constexpr double kSlack = 0.01;  // [m] so that a point on the edge of what margin is left does not touch it
  FreeWay free{kInfinity, {0.0, 0.0}};
  for (const auto& point : points_in_base) {
    const double ahead = std::abs(point.x()) - 0.5 * hull.length_m;
    const double aside = std::abs(point.y()) - 0.5 * hull.width_m;
    const double margin = std::clamp(std::max(ahead, aside) - kSlack, 0.0, margin_m);
    const double way = way_to_contact({hull.length_m + 2.0 * margin, hull.width_m + 2.0 * margin}, curvature, point);
    if (way < free.way_m) free = {way, point};
  }
  return free;
}

double speed_that_stops_within(double way_m, double reaction_time_s, double deceleration_mps2) {
  if (way_m <= 0.0) return 0.0;
  const double lost = deceleration_mps2 * reaction_time_s;
  return std::sqrt(lost * lost + 2.0 * deceleration_mps2 * way_m) - lost;
}

Pose2 start_from_end(double curvature, double way_m) {
  if (std::abs(curvature) < kStraight) return {way_m, 0.0, 0.0};
  const double angle = curvature * way_m;
  return {std::sin(angle) / curvature, (1.0 - std::cos(angle)) / curvature, wrap_to_pi(angle)};
}

}  // namespace tandem::navigator
