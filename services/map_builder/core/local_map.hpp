#pragma once

#include <optional>
#include <vector>

#include "services/localization/core/likelihood_field.hpp"
#include "services/localization/core/scan_search.hpp"
#include "services/map_builder/core/surface_index.hpp"

namespace tandem {

/// What was seen around the robot, to lay scans onto: as points, and as a likelihood field where a search wants one.
class LocalMap {
 public:
  /// `surface_in_map` is what was seen; the field reaches `reach_m` from `centre_in_map`.
  LocalMap(Surface surface_in_map, const Eigen::Vector2d& centre_in_map, double reach_m)
      : index_(std::move(surface_in_map)), centre_in_map_(centre_in_map), reach_m_(reach_m) {}

  [[nodiscard]] const SurfaceIndex& index() const { return index_; }
  /// The best pose of the window, on its lattice.
  [[nodiscard]] Pose2 best_pose(const Surface& scan, const Pose2& centre, const SearchWindow& window);

  /// Cells where something was seen are occupied, all others free: a search may put the robot anywhere.
  [[nodiscard]] OccupancyGrid grid(double resolution_m) const;
  [[nodiscard]] static LikelihoodField field_of(const OccupancyGrid& grid);

 private:
  SurfaceIndex index_;
  Eigen::Vector2d centre_in_map_;
  double reach_m_;
  std::optional<LikelihoodField> field_;  ///< drawn when first asked for
};

/// Where the points of `surface` are, `count` of them at most, no further than `reach_m`.
[[nodiscard]] std::vector<Eigen::Vector2d> points_of(const Surface& surface, std::size_t count, double reach_m);

}  // namespace tandem
