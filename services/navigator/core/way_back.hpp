#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

namespace tandem::navigator {

/// The last metres of the way on which the robot had a link: the way back to it.
class WayBack {
 public:
  /// Takes where the robot is while it has one.
  void take(const Eigen::Vector2d& position_in_map);
  /// From `position_in_map` back along the way, its newest point first.
  [[nodiscard]] std::vector<Eigen::Vector2d> points_from(const Eigen::Vector2d& position_in_map) const;

 private:
  std::deque<Eigen::Vector2d> points_;
};

}  // namespace tandem::navigator
