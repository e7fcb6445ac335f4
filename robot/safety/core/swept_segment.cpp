#include "robot/safety/core/swept_segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tandem::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStraight = 1e-6;   ///< [rad/s]
constexpr double kGlimpse_s = 1e-3;  ///< far enough ahead to see whether something comes closer
constexpr double kCloser_m = 1e-9;

std::array<Eigen::Vector2d, 4> corners_of(const Hull& hull) {
  const double x = hull.half_length_m;
  const double y = hull.half_width_m;
  return {{{x, y}, {-x, y}, {-x, -y}, {x, -y}}};
}

/// Whether the edge has a point within the closed rectangle: what is left of it after each side has cut.
bool overlaps(const Hull& hull, const Segment& edge) {
  const Eigen::Vector2d along = edge.to - edge.from;
  double first = 0.0;
  double last = 1.0;
  const auto cut = [&](double from, double step, double half) {
    if (step == 0.0) return std::abs(from) <= half;
    const double one = (-half - from) / step;
    const double other = (half - from) / step;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
    return first <= last;
  };
  return cut(edge.from.x(), along.x(), hull.half_length_m) && cut(edge.from.y(), along.y(), hull.half_width_m);
}

double distance_to_edge(const Eigen::Vector2d& point, const Segment& edge) {
  const Eigen::Vector2d along = edge.to - edge.from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - edge.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - edge.from - share * along).norm();
}

/// Where `point_in_base` is seen from the base after it moved for `time_s`.
Eigen::Vector2d seen_later(const Eigen::Vector2d& point_in_base, const Motion& motion, double time_s) {
  const double turn = motion.turn_rate_radps * time_s;
  const Eigen::Vector2d middle = motion.forward_mps * time_s * Eigen::Vector2d{std::cos(turn / 2), std::sin(turn / 2)};
  const Eigen::Vector2d left = point_in_base - middle;
  return {std::cos(turn) * left.x() + std::sin(turn) * left.y(), std::cos(turn) * left.y() - std::sin(turn) * left.x()};
}

bool comes_closer(const Hull& hull, const Motion& motion, const Segment& edge) {
  const Segment later{seen_later(edge.from, motion, kGlimpse_s), seen_later(edge.to, motion, kGlimpse_s)};
  return distance_to_hull(hull, later) < distance_to_hull(hull, edge) - kCloser_m;
}

/// When a corner that goes straight ahead crosses the edge.
double straight_crossing(const Eigen::Vector2d& corner, double forward_mps, const Segment& edge) {
  const Eigen::Vector2d along = edge.to - edge.from;
  if (forward_mps == 0.0 || along.y() == 0.0) return kNever;  // beside it: its ends are looked at anyway
  const double share = (corner.y() - edge.from.y()) / along.y();
  if (share < 0.0 || share > 1.0) return kNever;
  const double time_s = (edge.from.x() + share * along.x() - corner.x()) / forward_mps;
  return time_s >= 0.0 ? time_s : kNever;
}

/// When a corner that goes round the centre of the turn crosses the edge.
double arc_crossing(const Eigen::Vector2d& corner, const Motion& motion, const Segment& edge) {
  const Eigen::Vector2d centre{0.0, motion.forward_mps / motion.turn_rate_radps};
  const Eigen::Vector2d start = corner - centre;
  const Eigen::Vector2d along = edge.to - edge.from;
  const Eigen::Vector2d from = edge.from - centre;
  const double a = along.squaredNorm();
  if (a == 0.0) return kNever;
  const double b = from.dot(along) / a;
  const double c = (from.squaredNorm() - start.squaredNorm()) / a;
  if (b * b < c) return kNever;
  double smallest_turn = kNever;
  for (const double sign : {-1.0, 1.0}) {
    const double share = -b + sign * std::sqrt(b * b - c);
    if (share < 0.0 || share > 1.0) continue;
    const Eigen::Vector2d crossing = from + share * along;
    double turn = std::atan2(crossing.y(), crossing.x()) - std::atan2(start.y(), start.x());
    if (motion.turn_rate_radps < 0.0) turn = -turn;
    turn -= 2.0 * std::numbers::pi * std::floor(turn / (2.0 * std::numbers::pi));
    smallest_turn = std::min(smallest_turn, turn);
  }
  return smallest_turn / std::abs(motion.turn_rate_radps);
}

}  // namespace

double distance_to_hull(const Hull& hull, const Segment& edge_in_base) {
  if (overlaps(hull, edge_in_base)) return 0.0;
  double nearest = std::min(distance_to_hull(hull, edge_in_base.from), distance_to_hull(hull, edge_in_base.to));
  for (const auto& corner : corners_of(hull)) nearest = std::min(nearest, distance_to_edge(corner, edge_in_base));
  return nearest;
}

double time_to_contact(const Hull& hull, double margin_m, const Motion& motion, const Segment& edge_in_base) {
  if (overlaps(hull, edge_in_base)) return 0.0;
  const Hull grown = hull.grown(margin_m);
  if (overlaps(grown, edge_in_base)) return comes_closer(hull, motion, edge_in_base) ? 0.0 : kNever;
  double earliest = std::min(time_to_contact(grown, 0.0, motion, edge_in_base.from),
                             time_to_contact(grown, 0.0, motion, edge_in_base.to));
  const bool straight = std::abs(motion.turn_rate_radps) < kStraight;
  for (const auto& corner : corners_of(grown)) {
    earliest = std::min(earliest, straight ? straight_crossing(corner, motion.forward_mps, edge_in_base)
                                           : arc_crossing(corner, motion, edge_in_base));
  }
  return earliest;
}

}  // namespace tandem::safety
