#pragma once

#include <vector>

#include "services/planner/core/srs/resolved_world.hpp"

namespace tandem {

/// What it costs an agent to be at a place: the fixed sources that pay it a negative reward there. They bend its ways.
class Hazards {
 public:
  Hazards(const ResolvedWorld& world, std::size_t agent, double altitude_m);

  [[nodiscard]] bool empty() const { return sources_.empty(); }
  /// Cost of a second there [1/s], >= 0.
  [[nodiscard]] double cost_per_s(const Eigen::Vector2d& point_in_map) const;
  /// The integral of cost_per_s over the straight line [m/s]: what it costs at 1 m/s. Exact
  /// where the cost is constant within and without the boundaries, else by midpoints of at most 0.25 m.
  [[nodiscard]] double along(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  /// The largest cost of a second anywhere [1/s].
  [[nodiscard]] double peak_per_s() const { return peak_per_s_; }
  /// Points around each of them, a little outside, to walk over; of those without an end, none.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& detour_points() const { return detour_points_; }

 private:
  const ResolvedWorld* world_;
  std::size_t agent_;
  double altitude_m_;
  double peak_per_s_ = 0.0;
  bool is_stepwise_ = true;  ///< the cost changes at boundaries only
  std::vector<std::size_t> sources_;
  std::vector<Eigen::Vector2d> detour_points_;
};

}  // namespace tandem
