#include "services/navigator/core/zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "services/mapping/core/map_zones.hpp"

namespace tandem::navigator {
namespace {

constexpr double kSpacing_m = 0.1;  ///< of the points of an outline: far less than a hull
constexpr double kNear_m = 6.0;     ///< as far as avoidance looks ahead, and more

void add_edge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::vector<Eigen::Vector2d>& points) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSpacing_m)));
  for (int i = 0; i < pieces; ++i) points.emplace_back(from + (to - from) * i / pieces);
}

}  // namespace

Zones::Zones(std::vector<MapArea> areas) {
  for (MapArea& area : areas) {
    const auto& corners = area.corners_in_map;
    if (area.rule == AreaRule::KeepOut) {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        add_edge(corners[i], corners[(i + 1) % corners.size()], outlines_in_map_);
      }
    } else if (area.rule == AreaRule::Slow) {
      slow_.push_back(std::move(area));
    }
  }
}

void Zones::add_outlines(const Pose2& map_from_base, std::vector<Eigen::Vector2d>& obstacles_in_base) const {
  const Pose2 base_from_map = inverse(map_from_base);
  for (const auto& point : outlines_in_map_) {
    if ((point - map_from_base.position()).norm() <= kNear_m) obstacles_in_base.push_back(base_from_map * point);
  }
}

double Zones::speed_limit_mps(const Eigen::Vector2d& position_in_map, double hull_radius_m,
                              double deceleration_mps2) const {
  double limit_mps = std::numeric_limits<double>::infinity();
  for (const MapArea& area : slow_) {
    const double way_m = std::max(0.0, distance_to_area_m(area, position_in_map) - hull_radius_m);
    limit_mps =
        std::min(limit_mps, std::sqrt(area.max_speed_mps * area.max_speed_mps + 2.0 * deceleration_mps2 * way_m));
  }
  return limit_mps;
}

}  // namespace tandem::navigator
