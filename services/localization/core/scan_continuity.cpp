#include "services/localization/core/scan_continuity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tandem {
namespace {

constexpr double kMarginM = 0.15;         ///< A beam this much shorter than those around it has met the same thing, ...
constexpr double kMarginPerM = 0.03;      ///< ... and a bit more where they are long.
constexpr double kAroundRad = 0.03;       ///< Beams this close are around one.
constexpr std::size_t kFewestBeams = 40;  ///< that can be compared

struct Beam {
  double angle_rad;
  double range_m;
};

/// The beams by angle around the laser, each a second time where that is a full turn on: the circle has no end.
std::vector<Beam> by_angle(std::span<const Eigen::Vector2d> endpoints, const Eigen::Vector2d& laser) {
  std::vector<Beam> beams;
  beams.reserve(2 * endpoints.size());
  for (const Eigen::Vector2d& endpoint : endpoints) {
    const Eigen::Vector2d away = endpoint - laser;
    const double angle_rad = std::atan2(away.y(), away.x());
    const double other_rad = angle_rad + std::copysign(2.0 * std::numbers::pi, -angle_rad);
    beams.push_back({angle_rad, away.norm()});
    beams.push_back({other_rad, away.norm()});
  }
  std::ranges::sort(beams, {}, &Beam::angle_rad);
  return beams;
}

struct Count {
  std::size_t compared = 0;
  std::size_t contradicting = 0;
};

/// How many of `points` lie where `beams` from `laser` have passed.
Count in_free_space(const std::vector<Beam>& beams, const std::vector<Eigen::Vector2d>& points,
                    const Eigen::Vector2d& laser, double around_rad, double margin_m) {
  Count count;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d away = point - laser;
    const double angle_rad = std::atan2(away.y(), away.x());
    const auto first = std::ranges::lower_bound(beams, angle_rad - around_rad, {}, &Beam::angle_rad);
    const auto last = std::ranges::upper_bound(beams, angle_rad + around_rad, {}, &Beam::angle_rad);
    // Beams on one side only: at the edge of what the laser sees, or of a gap without returns.
    if (first == last || first->angle_rad > angle_rad || std::prev(last)->angle_rad < angle_rad) continue;
    double shortest_m = std::numeric_limits<double>::infinity();
    for (auto beam = first; beam != last; ++beam) shortest_m = std::min(shortest_m, beam->range_m);
    ++count.compared;
    if (away.norm() < (1.0 - kMarginPerM) * shortest_m - margin_m) ++count.contradicting;
  }
  return count;
}

std::vector<Eigen::Vector2d> moved(const Pose2& pose, std::span<const Eigen::Vector2d> points) {
  std::vector<Eigen::Vector2d> result;
  result.reserve(points.size());
  for (const Eigen::Vector2d& point : points) result.push_back(pose * point);
  return result;
}

}  // namespace

double contradiction_of(std::span<const Eigen::Vector2d> before, std::span<const Eigen::Vector2d> now,
                        const Eigen::Vector2d& laser_in_base, const Pose2& before_from_now,
                        const MotionDeviation& deviation) {
  const double around_rad = kAroundRad + deviation.turn_rad;
  const double margin_m = kMarginM + deviation.forward_m;
  const Count one =
      in_free_space(by_angle(before, laser_in_base), moved(before_from_now, now), laser_in_base, around_rad, margin_m);
  const Count other = in_free_space(by_angle(now, laser_in_base), moved(inverse(before_from_now), before),
                                    laser_in_base, around_rad, margin_m);
  const std::size_t compared = one.compared + other.compared;
  if (compared < 2 * kFewestBeams) return 0.0;
  return static_cast<double>(one.contradicting + other.contradicting) / static_cast<double>(compared);
}

}  // namespace tandem
