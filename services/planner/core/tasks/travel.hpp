#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "services/planner/core/motion/motion_map.hpp"
#include "services/planner/core/search/searcher.hpp"
#include "services/planner/core/tasks/hazards.hpp"

namespace tandem {

/// A way from one place to another.
struct TravelWay {
  std::vector<Eigen::Vector2d> points_in_map;  ///< [m], both ends included
  double length_m = 0.0;
  double hazard = 0.0;  ///< What it costs at 1 m/s: Hazards::along.
};

/// The places an agent goes to, and its ways between them: straight on an open plane, on the motion map of its body and
/// layer in a room. Ways are found when first asked for and kept.
///
/// Ways follow non-negative travel cost only (digest E1): time, and what hazards cost. How much time a hazard is worth
/// depends on the plan, so there may be several ways: the fastest first, then more careful ones.
class Travel {
 public:
  /// `motion` and `hazards` must outlive it; without `motion` the plane is open. `cost_of_time_per_s` is what a second
  /// of walking costs, >= 0 [1/s].
  Travel(const MotionMap* motion, const Hazards* hazards, const Searcher& searcher, double cost_of_time_per_s);

  /// The place at a point, added if it is new; none if the body cannot stand within `reach_m` of it.
  [[nodiscard]] std::optional<int> place_at(const Eigen::Vector2d& point_in_map, double reach_m);
  [[nodiscard]] const Eigen::Vector2d& point(int place) const { return points_[static_cast<std::size_t>(place)]; }
  /// All ways, the fastest first; none where no way leads.
  [[nodiscard]] const std::vector<TravelWay>& ways(int from, int to);
  /// Whether the body gets along the straight line.
  [[nodiscard]] bool is_clear(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

 private:
  [[nodiscard]] std::optional<TravelWay> way_on_plane(int from, int to, double surcharge_s) const;
  [[nodiscard]] std::optional<TravelWay> way_in_room(int from, int to, double surcharge_s);
  [[nodiscard]] TravelWay way_over(std::vector<Eigen::Vector2d> points) const;

  const MotionMap* motion_;
  const Hazards* hazards_;
  double radius_m_;
  double preferred_clearance_m_;
  std::vector<double> surcharges_s_;  ///< metres that a unit of hazard cost is worth, per way asked for
  std::vector<Eigen::Vector2d> points_;
  std::vector<int> nodes_;                              ///< of motion_
  std::map<std::pair<int, int>, ShortestPaths> paths_;  ///< by place and number of surcharge
  std::map<std::pair<int, int>, std::vector<TravelWay>> ways_;
};

}  // namespace tandem
