#include "services/navigator/core/way_back.hpp"

namespace tandem::navigator {
namespace {

constexpr double kBetween_m = 0.25;
constexpr std::size_t kMostPoints = 40;  ///< ten metres, as far as the gate lets it go

}  // namespace

void WayBack::take(const Eigen::Vector2d& position_in_map) {
  if (!points_.empty() && (position_in_map - points_.back()).norm() < kBetween_m) return;
  points_.push_back(position_in_map);
  if (points_.size() > kMostPoints) points_.pop_front();
}

std::vector<Eigen::Vector2d> WayBack::points_from(const Eigen::Vector2d& position_in_map) const {
  std::vector<Eigen::Vector2d> points{position_in_map};
  points.insert(points.end(), points_.rbegin(), points_.rend());
  return points;
}

}  // namespace tandem::navigator
