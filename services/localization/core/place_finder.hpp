#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/global_search.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/panorama.hpp"

namespace tandem {

/// One place where the robot may be.
struct PoseHypothesis {
  Pose2 map_from_base;
  double weight = 0.0;  ///< [0, 1]
};

/// Where on the whole map the robot may be.
struct Finding {
  std::vector<PoseHypothesis> places;  ///< heaviest first; the weights add up to 1
  double score = 0.0;                  ///< of the first, see Candidate
  bool certain = false;                ///< the first has been alone and the same for long enough
};

/// When a place is found beyond doubt.
struct PlaceFinderOptions {
  Panorama::Extent panorama;
  double cell_m = 0.2;                                ///< The panorama holds one point in each square of this side ...
  std::size_t points = 150;                           ///< ... and at most so many are compared with the map.
  double search_every_m = 0.4;                        ///< The whole map is searched again after this way.
  double weight_per_score = 40.0;                     ///< log weight that a place gains by a score of 1
  double certain_weight = 0.9;                        ///< Share of all weight ...
  double certain_after_m = 1.0;                       ///< ... that a place must hold over this way ...
  Duration certain_after = std::chrono::seconds{10};  ///< ... or time.
};

/// Finds the robot anywhere on the map while it drives: what it saw on the last metres is compared with every place.
///
/// A turn counts as way too, for the robot sees something new.
class PlaceFinder {
 public:
  PlaceFinder(const OccupancyGrid& map, const LikelihoodField& field, const PlaceFinderOptions& options);

  /// Takes a scan with the odometry at its time.
  void add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base);
  /// What was seen so far was seen elsewhere: the robot was carried away, or its wheels slipped.
  void forget();

  /// Where the robot may be at the last scan added. Searches when the robot has moved on, else carries the last places
  /// along by odometry.
  [[nodiscard]] const Finding& find();

  /// How well a pose at the last scan explains what the last search compared: to be held against Finding::score.
  [[nodiscard]] double score_at(const Pose2& map_from_base) const;

  /// Driven so far [m], with turns.
  [[nodiscard]] double way_m() const { return way_m_; }
  [[nodiscard]] const Finding& last_finding() const { return finding_; }

  /// May two poses be one place?
  [[nodiscard]] static bool is_same(const Pose2& a, const Pose2& b);

 private:
  void search();

  PlaceFinderOptions options_;
  GlobalSearch search_;
  Panorama panorama_;
  std::vector<Eigen::Vector2d> points_;  ///< compared, from the base at the last search
  bool is_new_ = false;                  ///< has a scan come since the last search?
  OdometrySample last_;                  ///< at the last scan
  Pose2 found_at_;                       ///< odom_from_base to which the places belong
  Pose2 searched_at_;                    ///< odom_from_base of the last search
  double way_m_ = 0.0;
  double searched_at_m_ = 0.0;
  double leading_since_m_ = 0.0;
  Time leading_since_{};
  Finding finding_;
};

}  // namespace tandem
