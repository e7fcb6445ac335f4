#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/common/config.hpp"
#include "services/localization/core/motion_noise.hpp"

namespace tandem {

/// config/<place>/localization.toml. See docs/localization.md for what each part does.
struct LocalizationConfig {
  std::int64_t seed = 1;           ///< Of all random draws.
  std::string scans = "all";       ///< "odd": use scans 1, 3, 5, ... of 0, 1, 2, ... alone.
  std::vector<double> start;       ///< [x m, y m, heading rad] at the first scan used; empty: wait for a pose hint.
  double start_deviation_m = 0.1;  ///< Standard deviation of the start pose; its heading: the same in rad.
  bool start_globally = false;     ///< Without a start pose: look for the robot on the whole map.

  MotionNoise wheels = kUncalibratedWheels;  ///< How wrong odometry is: forward_per_m, ..., drift_rad.
  double odometry_max_age_s = 0.2;           ///< A scan without odometry this recent is not used.
  double prediction_max_age_s = 0.5;         ///< The pose goes on by odometry for this long after the last scan.
  double distrust_factor = 4.0;              ///< Odometry noise is multiplied by this after it was caught wrong ...
  double distrust_s = 4.0;                   ///< ... for this long.

  double range_limit_m = 25.0;      ///< Longer beams are not used.
  std::int64_t filter_beams = 60;   ///< Beams that weigh the particles.
  std::int64_t refine_beams = 180;  ///< Beams that refine the best pose and measure its agreement.
  double hit_deviation_m = 0.12;    ///< Likelihood field: spread of returns around a wall.
  double random_share = 0.15;       ///< ... share of returns from things that are not on the map.
  double beam_weight = 0.25;        ///< Neighbouring beams err together: each counts as this much of one.

  std::int64_t particles_min = 300;
  std::int64_t particles_max = 2'000;
  double kld_error = 0.05;      ///< The particle count keeps the filter's error below this ...
  double kld_quantile = 2.33;   ///< ... at this quantile of the standard normal (2.33: 99 %).
  double resample_below = 0.5;  ///< Effective share of particles below which they are drawn anew.
  double refined_share = 0.1;   ///< Share of the particles put at the refined pose when it fits.
  double min_motion_m = 0.02;   ///< A robot that moved less ...
  double min_turn_rad = 0.01;   ///< ... and turned less since the last update learns nothing from a scan.

  double refine_loss_m = 0.1;       ///< Residual where the robust loss begins to flatten.
  double prior_deviation_m = 0.15;  ///< The filter's pose holds the refined one this loosely.
  double prior_deviation_rad = 0.1;
  std::int64_t window_scans = 3;       ///< Poses refined together; 0: the filter alone.
  double refine_beam_weight = 0.5;     ///< ... each beam counting as this much of one: neighbours err together.
  double map_deviation_cells = 0.025;  ///< How wrong a map is whatever scans say, for the covariance [its cells].

  double fit_distance_m = 0.2;  ///< A beam fits the map when it ends this close to a wall and came through none.
  double agreement_ok = 0.65;   ///< Share of fitting beams from which a pose is believed.
  double lost_after_s = 2.0;    ///< Below agreement_ok for this long: lost.
  double break_above = 0.2;     ///< Share of contradicting beams between two scans from which the robot was moved.
  double doubt_below = 0.75;    ///< When the mean of the last scans is below, other places are looked at too ...
  double doubt_every_m = 2.0;   ///< ... each time the robot drove this far ...
  double doubt_score = 0.08;    ///< ... and one that explains the last metres better by this is believed possible.

  double panorama_way_m = 3.5;            ///< The scans of this way, together, are looked for on the whole map.
  double search_boxes_per_s = 1'000'000;  ///< ... by scoring so many boxes of poses for each second that passes.
  double place_weight_per_score = 40;     ///< Log weight that a place gains by a score of 1 (all ends on walls).
  double place_certain_weight = 0.9;      ///< A place with this share of all weight ...
  double place_certain_m = 1.0;           ///< ... over this way is believed.

  std::string last_pose_file;        ///< Keeps the pose over a restart; empty: it is not kept.
  double last_pose_max_age_s = 600;  ///< A kept pose older than this is not used.
  double last_pose_fresh_s = 5.0;    ///< One at most this old is believed as soon as the first scan agrees.

  double search_below = 0.85;        ///< Share of fitting beams below which the surroundings are searched.
  double search_window_m = 1.2;      ///< Half the side of the square searched when the scan does not fit ...
  double search_window_rad = 0.3;    ///< ... and the turn each way.
  double search_prior_weight = 0.3;  ///< What leaving the prediction by a whole window costs [log likelihood/beam].

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    const Range share{0.0, 1.0};
    const Range length_m{1e-3, 100.0};
    visitor.field("seed", seed, Range{0, 1e15});
    visitor.field("scans", scans, {"all", "odd"});
    visitor.field("start", start, Range{-1e5, 1e5});
    visitor.field("start_deviation_m", start_deviation_m, length_m);
    visitor.field("start_globally", start_globally);
    wheels.visit_fields(visitor);
    visitor.field("odometry_max_age_s", odometry_max_age_s, Range{0.0, 2.0});
    visitor.field("prediction_max_age_s", prediction_max_age_s, Range{0.0, 5.0});
    visitor.field("distrust_factor", distrust_factor, Range{1.0, 20.0});
    visitor.field("distrust_s", distrust_s, Range{0.0, 60.0});
    visitor.field("range_limit_m", range_limit_m, Range{1.0, 200.0});
    visitor.field("filter_beams", filter_beams, Range{10, 1000});
    visitor.field("refine_beams", refine_beams, Range{10, 2000});
    visitor.field("hit_deviation_m", hit_deviation_m, Range{0.01, 2.0});
    visitor.field("random_share", random_share, Range{0.001, 0.999});
    visitor.field("beam_weight", beam_weight, Range{0.001, 1.0});
    visitor.field("particles_min", particles_min, Range{10, 100'000});
    visitor.field("particles_max", particles_max, Range{10, 100'000});
    visitor.field("kld_error", kld_error, Range{0.001, 0.5});
    visitor.field("kld_quantile", kld_quantile, Range{0.5, 5.0});
    visitor.field("resample_below", resample_below, share);
    visitor.field("refined_share", refined_share, Range{0.0, 0.5});
    visitor.field("min_motion_m", min_motion_m, Range{0.0, 1.0});
    visitor.field("min_turn_rad", min_turn_rad, Range{0.0, 1.0});
    visitor.field("refine_loss_m", refine_loss_m, length_m);
    visitor.field("prior_deviation_m", prior_deviation_m, length_m);
    visitor.field("prior_deviation_rad", prior_deviation_rad, length_m);
    visitor.field("window_scans", window_scans, Range{0, 20});
    visitor.field("refine_beam_weight", refine_beam_weight, Range{0.001, 1.0});
    visitor.field("map_deviation_cells", map_deviation_cells, Range{0.0, 10.0});
    visitor.field("fit_distance_m", fit_distance_m, length_m);
    visitor.field("agreement_ok", agreement_ok, share);
    visitor.field("lost_after_s", lost_after_s, Range{0.0, 60.0});
    visitor.field("break_above", break_above, share);
    visitor.field("doubt_below", doubt_below, share);
    visitor.field("doubt_every_m", doubt_every_m, Range{0.1, 100.0});
    visitor.field("doubt_score", doubt_score, share);
    visitor.field("panorama_way_m", panorama_way_m, Range{0.1, 50.0});
    visitor.field("search_boxes_per_s", search_boxes_per_s, Range{1'000, 1e9});
    visitor.field("place_weight_per_score", place_weight_per_score, Range{1.0, 1000.0});
    visitor.field("place_certain_weight", place_certain_weight, Range{0.5, 1.0});
    visitor.field("place_certain_m", place_certain_m, Range{0.0, 100.0});
    visitor.field("last_pose_file", last_pose_file);
    visitor.field("last_pose_max_age_s", last_pose_max_age_s, Range{0.0, 1e6});
    visitor.field("last_pose_fresh_s", last_pose_fresh_s, Range{0.0, 60.0});
    visitor.field("search_below", search_below, share);
    visitor.field("search_window_m", search_window_m, Range{0.05, 20.0});
    visitor.field("search_window_rad", search_window_rad, Range{0.01, 3.2});
    visitor.field("search_prior_weight", search_prior_weight, Range{0.0, 100.0});
  }
};

}  // namespace tandem
