#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/likelihood_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A place where beams fit the map.
struct Candidate {
  Pose2 map_from_base;
  double score = 0.0;  ///< mean over the beams, [0, 1]: 0 all far from walls, 1 all on walls
};

/// Poses around a centre: a square whose sides lie along the map's grid, and a turn each way.
struct PoseArea {
  Pose2 centre_in_map;
  double half_side_m = 0.0;
  double half_turn_rad = 0.0;
};

/// What a global search looks for.
struct GlobalSearchOptions {
  double step_rad = 0.025;          ///< between two headings tried
  std::size_t count = 8;            ///< candidates wanted at most
  double margin = 0.12;             ///< a candidate worse than the best by more is none
  double apart_m = 0.7;             ///< two candidates are this far apart ...
  double apart_rad = 0.3;           ///< ... or turned by this much
  std::size_t max_nodes = 600'000;  ///< boxes of poses opened before the search gives up and says what it has
  std::optional<PoseArea> within;   ///< only poses in here, to a lattice step; none: the whole map
};

/// Finds where on the whole map beams fit, with no start value: branch and bound over boxes of poses.
///
/// A pyramid of the likelihood field gives for each box of 2^h x 2^h lattice positions the best a beam can score in it;
/// so the best poses are found without trying all (Olson, ICRA 2015; Hess et al., ICRA 2016). Only positions on free
/// cells count.
class GlobalSearch {
 public:
  GlobalSearch(const OccupancyGrid& map, const LikelihoodField& field);

  /// Beams that end further away than this are left out [m].
  static constexpr double kReachM = 15.0;

  /// The best places, best first, each on the lattice: half a lattice step and half a turn step from its peak at most.
  [[nodiscard]] std::vector<Candidate> candidates(std::span<const Eigen::Vector2d> endpoints_in_base,
                                                  const GlobalSearchOptions& options) const;

  /// The score of one pose, on the lattice nearest to it; 0 for no endpoints.
  [[nodiscard]] double score_at(const Pose2& map_from_base, std::span<const Eigen::Vector2d> endpoints_in_base) const;

  [[nodiscard]] double step_m() const { return step_m_; }

 private:
  /// One byte for each lattice position, and a rim around the map as wide as the longest beam: no look-up can miss.
  ///
  /// The value of (i, j) is the largest of those from (i, j) to (i + 2^h - 1, j + 2^h - 1).
  using Level = std::vector<std::uint8_t>;

  [[nodiscard]] Level pooled(const Level& finer, int half) const;
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row + rim_) * static_cast<std::size_t>(padded_width_) +
           static_cast<std::size_t>(column + rim_);
  }

  Pose2 map_from_grid_;
  Pose2 grid_from_map_;
  double step_m_;
  int width_;
  int height_;
  int rim_;
  int padded_width_;
  int padded_height_;
  std::vector<Level> fit_;   ///< 255: on a wall
  std::vector<Level> free_;  ///< not 0: the robot can be there
};

}  // namespace tandem
