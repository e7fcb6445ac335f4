#include "services/localization/core/panorama.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace tandem {

void Panorama::add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base) {
  if (odometry.epoch != epoch_) clear();
  epoch_ = odometry.epoch;
  double way_m = 0.0;
  if (!views_.empty()) {
    way_m = views_.back().way_m + (odometry.odom_from_base.position() - views_.back().odom_from_base.position()).norm();
  }
  if (views_.size() > 1) {
    const Pose2& kept = std::prev(views_.end(), 2)->odom_from_base;
    const Pose2 motion = inverse(kept) * views_.back().odom_from_base;
    if (motion.position().norm() < extent_.spacing_m && std::abs(motion.heading) < extent_.spacing_rad) {
      views_.pop_back();
    }
  }
  views_.push_back({odometry.odom_from_base, way_m, {endpoints_in_base.begin(), endpoints_in_base.end()}});
  while (views_.back().way_m - views_.front().way_m > extent_.way_m) views_.pop_front();
}

std::vector<Eigen::Vector2d> Panorama::endpoints_in_base(double cell_m) const {
  std::vector<Eigen::Vector2d> points;
  if (views_.empty()) return points;
  std::set<std::pair<std::int64_t, std::int64_t>> taken;
  const Pose2 base_from_odom = inverse(views_.back().odom_from_base);
  for (auto view = views_.rbegin(); view != views_.rend(); ++view) {  // the newest is the least drifted
    const Pose2 base_from_then = base_from_odom * view->odom_from_base;
    for (const Eigen::Vector2d& endpoint : view->endpoints_in_base) {
      const Eigen::Vector2d point = base_from_then * endpoint;
      const auto cell = std::pair{std::llround(point.x() / cell_m), std::llround(point.y() / cell_m)};
      if (taken.insert(cell).second) points.push_back(point);
    }
  }
  return points;
}

double Panorama::way_m() const {
  return views_.empty() ? 0.0 : views_.back().way_m - views_.front().way_m;
}

}  // namespace tandem
