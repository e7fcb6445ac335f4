#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
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
/// A turn counts as way too, for the robot sees something new. A search takes as many pieces of work as it needs, while
/// the robot drives on; what it finds is carried along by odometry.
class PlaceFinder {
 public:
  PlaceFinder(const OccupancyGrid& map, const LikelihoodField& field, const PlaceFinderOptions& options);

  /// Takes a scan with the odometry at its time, and carries the places along to it.
  void add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base);
  /// What was seen so far was seen elsewhere: the robot was carried away, or its wheels slipped.
  void forget();

  /// Asks where the robot is, to be called with each scan while that is wanted: begins a search unless one is running
  /// or the last one is recent. After a scan at which nobody asked, what was found is forgotten and the search ended.
  void seek();
  /// Goes on with the search that is running, if one is, by about `boxes` boxes of poses.
  void advance(std::size_t boxes);
  [[nodiscard]] bool is_searching() const { return search_.has_value(); }

  /// Where the robot may be at the last scan added, by the last search that ended.
  [[nodiscard]] const Finding& finding() const { return finding_; }
  /// How well a pose at the last scan explains what that search compared: to be held against Finding::score.
  [[nodiscard]] double score_at(const Pose2& map_from_base) const;

  /// Driven so far [m], with turns.
  [[nodiscard]] double way_m() const { return way_m_; }

  /// The map as it is searched.
  [[nodiscard]] const GlobalSearch& map() const { return map_; }

  /// May two poses be one place?
  [[nodiscard]] static bool is_same(const Pose2& a, const Pose2& b);

 private:
  /// What is compared with the map, and where it was seen.
  struct Question {
    std::vector<Eigen::Vector2d> points_in_base;
    OdometrySample at;
    double way_m = 0.0;
  };
  struct Search {
    Question question;
    GlobalSearchRun run;
  };

  void adopt(const Search& search);
  void judge();

  PlaceFinderOptions options_;
  GlobalSearch map_;
  Panorama panorama_;
  OdometrySample last_;  ///< at the last scan
  double way_m_ = 0.0;
  bool asked_ = false;            ///< since the last scan
  std::optional<Search> search_;  ///< the one that is running
  Question answered_;             ///< to which the finding belongs
  double leading_since_m_ = 0.0;  ///< way_m when the first place was first found
  Time leading_since_{};
  Finding finding_;
};

}  // namespace tandem
