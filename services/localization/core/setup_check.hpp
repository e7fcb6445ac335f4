#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/global_search.hpp"
#include "services/localization/core/input_faults.hpp"
#include "services/localization/core/map_scale.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/panorama.hpp"

namespace tandem {

/// When another setup than the configured one is believed.
struct SetupCheckOptions {
  Panorama::Extent panorama;
  double cell_m = 0.2;          ///< as the finder of places compares
  std::size_t points = 150;     ///< as the finder of places compares
  double clearly_better = 0.1;  ///< The score must be better by this than that of any place as things are set up, ...
  double least_score = 0.75;    ///< ... and no less than this, ...
  int votes = 3;                ///< ... so often in a row, ...
  double apart_m = 0.5;         ///< ... each time after so much more way.
  MapScaleOptions scale;        ///< When a scale measured on the way is believed.
};

/// Tells why no place fits: the laser is mounted upside down (left and right exchanged), or the map has a wrong scale.
///
/// What was seen on the last metres is looked for on the whole map as it would be then, one alternative after the
/// other, a bounded piece of work at a time. One that was named stays so where nothing tells it from things as they are
/// set up; it takes places that fit well and better without it to withdraw it. A scale so little wrong that places are
/// found all the same is measured on the way.
class SetupCheck {
 public:
  explicit SetupCheck(const SetupCheckOptions& options);

  /// Takes a scan with the odometry at its time and the way driven so far.
  void add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base,
           const Pose2& base_from_laser, double way_m);
  /// Takes a scan that fits the map at `map_from_base`, after add(): is all of it a little too large or too small?
  void add_fit(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
               const Pose2& map_from_base, const Eigen::Vector2d& laser_in_base);
  /// What was seen so far was seen elsewhere.
  void forget();

  /// Goes on by about `boxes` boxes; `score` is the best that any place reaches as things are set up.
  void advance(const GlobalSearch& map, double score, std::size_t boxes);

  /// LaserMirrored or MapScaleWrong, once the evidence is there and as long as it holds.
  [[nodiscard]] std::optional<InputFault> fault() const;
  /// Is it so wrong that no place can be right? A scale measured on the way leaves the robot where it is, nearly.
  [[nodiscard]] bool rules_out_places() const { return is_named_; }
  /// With MapScaleWrong: lengths on the map are this many times as long as they are.
  [[nodiscard]] double map_scale() const {
    return is_named_ ? alternatives_[current_].scale : scale_.wrong_scale().value_or(1.0);
  }

 private:
  struct Alternative {
    bool mirrored = false;
    double scale = 1.0;  ///< of what was seen
  };

  [[nodiscard]] std::vector<Eigen::Vector2d> points_of(const Alternative& alternative) const;
  /// How well an alternative explains what was seen, beside things as they are set up.
  enum class Verdict { Worse, Neither, Better };

  void begin(const GlobalSearch& map, double score);
  [[nodiscard]] Verdict verdict() const;
  void conclude(Verdict verdict);

  SetupCheckOptions options_;
  std::vector<Alternative> alternatives_;
  std::size_t current_ = 0;
  int votes_ = 0;          ///< for the current one
  bool is_named_ = false;  ///< did they suffice?
  Panorama seen_;
  Panorama mirrored_;
  double way_m_ = 0.0;
  double all_begun_at_m_ = -1e9;  ///< way_m_ when the first of all was last searched for
  double begun_at_m_ = -1e9;      ///< way_m_ of the last search for the current one
  std::optional<GlobalSearchRun> run_;
  double asked_score_ = 0.0;  ///< that the run's result is held against
  MapScaleWatch scale_;
};

}  // namespace tandem
