#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/likelihood_field.hpp"
#include "services/localization/core/search_limits.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A place where beams fit the map.
struct Candidate {
  Pose2 map_from_base;
  double score = 0.0;  ///< mean over the beams, [0, 1]: 0 all far from walls, 1 all on walls
};

/// What a global search looks for.
struct GlobalSearchOptions {
  double step_rad = 0.025;          ///< between two headings tried
  std::size_t count = 8;            ///< candidates wanted at most
  double margin = 0.12;             ///< a candidate worse than the best by more is none
  double floor = 0.0;               ///< nor is one with a lower score
  double apart_m = 0.7;             ///< two candidates are this far apart ...
  double apart_rad = 0.3;           ///< ... or turned by this much
  std::size_t max_nodes = 600'000;  ///< boxes of poses opened before the search gives up and says what it has
  std::optional<PoseArea> within;   ///< only poses in here, to a lattice step; none: the whole map
};

/// A map made ready to be searched as a whole, with no start value.
///
/// A pyramid of the likelihood field gives for each box of 2^h x 2^h lattice positions the best a beam can score in it;
/// so the best poses are found without trying all (Olson, ICRA 2015; Hess et al., ICRA 2016). Only positions on free
/// cells count.
class GlobalSearch {
 public:
  GlobalSearch(const OccupancyGrid& map, const LikelihoodField& field);

  /// Beams that end further away than this are left out [m].
  static constexpr double kReachM = 15.0;
  static constexpr int kLevels = 7;  ///< The largest box is 2^6 lattice steps wide.

  /// The best places, best first, each on the lattice: half a lattice step and half a turn step from its peak at most.
  [[nodiscard]] std::vector<Candidate> candidates(std::span<const Eigen::Vector2d> endpoints_in_base,
                                                  const GlobalSearchOptions& options) const;

  /// The score of one pose, on the lattice nearest to it; 0 for no endpoints.
  [[nodiscard]] double score_at(const Pose2& map_from_base, std::span<const Eigen::Vector2d> endpoints_in_base) const;

  [[nodiscard]] double step_m() const { return step_m_; }
  [[nodiscard]] int width() const { return width_; }    ///< [lattice steps]
  [[nodiscard]] int height() const { return height_; }  ///< [lattice steps]
  [[nodiscard]] const Pose2& grid_from_map() const { return grid_from_map_; }
  [[nodiscard]] Pose2 in_map(const Pose2& grid_from_base) const { return map_from_grid_ * grid_from_base; }

  /// How far apart two positions lie in memory that lie `way_m` apart on the lattice.
  [[nodiscard]] std::ptrdiff_t shift_of(const Eigen::Vector2d& way_m) const;
  /// May the robot be somewhere in the box of `level` whose lower left is there?
  [[nodiscard]] bool is_free(int level, int column, int row) const {
    return free_[static_cast<std::size_t>(level)][index(column, row)] != 0;
  }
  /// The best sum that beams, each `shifts` away from the base, can score in that box; 255 each on walls. None where it
  /// is below `least`: beams are not looked at once the rest cannot make up for those before.
  [[nodiscard]] std::optional<int> best_sum(int level, int column, int row, std::span<const std::ptrdiff_t> shifts,
                                            int least) const;

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

/// A search on its way: a bounded piece of work at a time, and the same result however it is divided.
class GlobalSearchRun {
 public:
  GlobalSearchRun(const GlobalSearch& search, std::span<const Eigen::Vector2d> endpoints_in_base,
                  const GlobalSearchOptions& options);

  /// Goes on by scoring about `boxes` boxes of poses (four more at most); `search` is the one it began with.
  void advance(const GlobalSearch& search, std::size_t boxes);
  [[nodiscard]] bool is_done() const { return done_; }
  /// Did it end because it had opened as many boxes as it may? There may be better places then.
  [[nodiscard]] bool gave_up() const { return opened_ == options_.max_nodes; }
  /// Once it is done: as GlobalSearch::candidates.
  [[nodiscard]] const std::vector<Candidate>& candidates() const { return found_; }

 private:
  /// A box of positions at one heading.
  struct Box {
    int score = 0;  ///< sum over the beams, never below that of any pose in the box
    int heading = 0;
    int level = 0;
    int column = 0;
    int row = 0;

    /// Highest score first; then an order of its own, so that equal inputs give equal results.
    friend bool operator<(const Box& a, const Box& b) {
      return std::tie(a.score, b.level, b.heading, b.row, b.column) <
             std::tie(b.score, a.level, a.heading, a.row, a.column);
    }
  };

  [[nodiscard]] double heading_of(int heading) const;
  /// The lowest sum that is still looked for.
  [[nodiscard]] double least_sum() const;
  void score(const GlobalSearch& search, Box box);
  void begin_heading(int heading);
  void score_next_of_largest(const GlobalSearch& search);
  [[nodiscard]] bool is_known(const GlobalSearch& search, const Box& box) const;
  void open_best(const GlobalSearch& search);
  void finish(const GlobalSearch& search);

  GlobalSearchOptions options_;
  SearchLimits limits_;
  std::vector<std::vector<std::ptrdiff_t>> shifts_;  ///< by heading: from the base to the ends of the beams
  double full_ = 0.0;                                ///< the sum when all end on walls
  std::priority_queue<Box> boxes_;
  Box next_;                ///< of the largest boxes, which are all scored before the first is opened
  bool all_begun_ = false;  ///< they are
  std::size_t opened_ = 0;
  std::size_t scored_ = 0;
  std::vector<Candidate> found_;  ///< while it runs: poses in the grid's frame
  bool done_ = false;
};

}  // namespace tandem
