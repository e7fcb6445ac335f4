#pragma once

#include <cstdint>

#include "services/common/config.hpp"
#include "services/localization/core/motion_noise.hpp"

namespace tandem {

/// How a map is built; docs/mapping.md says what each part does. The same values serve indoors and outdoors.
struct MapBuilderConfig {
  double range_limit_m = 30.0;      ///< Longer beams are not used.
  std::int64_t scan_points = 180;   ///< Points of a scan that are laid onto others.
  double odometry_max_age_s = 0.2;  ///< A scan without odometry this recent is not used.
  double keep_motion_m = 0.03;      ///< A scan that moved less ...
  double keep_turn_rad = 0.02;      ///< ... and turned less since the last one kept ...
  double keep_after_s = 0.5;        ///< ... is left out until this time has gone.
  double node_spacing_m = 0.25;     ///< A scan becomes a node of the graph when the robot moved this far ...
  double node_spacing_rad = 0.2;    ///< ... or turned this far since the last node.

  MotionNoise wheels = kUncalibratedWheels;  ///< How wrong odometry is: forward_per_m, ..., drift_rad.

  double local_way_m = 8.0;         ///< A scan is laid onto what the nodes of this way before it saw.
  double local_cell_m = 0.04;       ///< ... one point in each square of this side.
  double first_reach_m = 0.4;       ///< A point is paired with the nearest one within this at first ...
  double last_reach_m = 0.15;       ///< ... and within this at last.
  double loss_m = 0.05;             ///< Pairs further apart than this count less and less.
  double point_deviation_m = 0.03;  ///< Spread of points across a surface.
  double point_weight = 0.3;        ///< Neighbouring points err together: each counts as this much of one.

  double search_below = 0.6;       ///< Share of matched points below which the surroundings are searched ...
  double search_window_m = 1.2;    ///< ... this far each way ...
  double search_window_rad = 0.4;  ///< ... and turned this much each way.

  double closure_every_m = 2.0;        ///< After each such way the robot looks for places it has been at.
  double closure_way_m = 5.0;          ///< What it saw on this last way, together, is looked for ...
  double closure_min_way_m = 15.0;     ///< ... in what it saw longer ago than this.
  double closure_window_m = 1.0;       ///< How far off it may be at least, each way ...
  double closure_window_per_m = 0.03;  ///< ... and more for each metre since the last closure ...
  double closure_window_max_m = 15.0;  ///< ... but not more than this.
  double closure_window_rad = 0.1;     ///< The same for its heading.
  double closure_window_rad_per_m = 0.002;
  double closure_window_max_rad = 0.6;
  double closure_score = 0.55;          ///< A place that fits less is none [0, 1].
  double closure_margin = 0.04;         ///< Another place within this of the best makes it doubtful.
  double closure_matched = 0.7;         ///< Share of matched points that a closure needs.
  double closure_far_m = 0.7;           ///< A closure that moves the robot further must be confirmed by the next.
  double closure_agreement_m = 0.5;     ///< Two closures agree when they move the robot alike to this ...
  double closure_agreement_rad = 0.06;  ///< ... and this.
  double closure_loss = 3.0;            ///< Closures off by more of their deviations count less and less (Cauchy).
  double closure_reject = 12.0;         ///< A closure off by more of its deviations than this is rejected.

  std::int64_t refine_rounds = 2;      ///< How often all neighbouring scans are laid onto each other at the end.
  double refine_reach_m = 4.0;         ///< Neighbours are this close ...
  std::int64_t refine_neighbours = 6;  ///< ... and so many of them at most that are not next on the way.
  double refine_matched = 0.45;        ///< Share of matched points that two neighbours need.
  double refine_loss = 2.0;            ///< Neighbours off by more of their deviations count less and less (Cauchy).

  double resolution_m = 0.05;    ///< Of the map.
  double occupied_share = 0.25;  ///< A cell is occupied when at least this share of the beams ended in it.
  double margin_m = 1.0;         ///< Unknown rim around the map.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    const Range share{0.0, 1.0};
    const Range length_m{1e-3, 200.0};
    const Range angle_rad{1e-4, 3.2};
    visitor.field("range_limit_m", range_limit_m, length_m);
    visitor.field("scan_points", scan_points, Range{20, 2000});
    visitor.field("odometry_max_age_s", odometry_max_age_s, Range{0.0, 2.0});
    visitor.field("keep_motion_m", keep_motion_m, Range{0.0, 1.0});
    visitor.field("keep_turn_rad", keep_turn_rad, Range{0.0, 1.0});
    visitor.field("keep_after_s", keep_after_s, Range{0.0, 10.0});
    visitor.field("node_spacing_m", node_spacing_m, length_m);
    visitor.field("node_spacing_rad", node_spacing_rad, angle_rad);
    wheels.visit_fields(visitor);
    visitor.field("local_way_m", local_way_m, length_m);
    visitor.field("local_cell_m", local_cell_m, length_m);
    visitor.field("first_reach_m", first_reach_m, length_m);
    visitor.field("last_reach_m", last_reach_m, length_m);
    visitor.field("loss_m", loss_m, length_m);
    visitor.field("point_deviation_m", point_deviation_m, length_m);
    visitor.field("point_weight", point_weight, Range{0.001, 1.0});
    visitor.field("search_below", search_below, share);
    visitor.field("search_window_m", search_window_m, length_m);
    visitor.field("search_window_rad", search_window_rad, angle_rad);
    visitor.field("closure_every_m", closure_every_m, length_m);
    visitor.field("closure_way_m", closure_way_m, length_m);
    visitor.field("closure_min_way_m", closure_min_way_m, length_m);
    visitor.field("closure_window_m", closure_window_m, length_m);
    visitor.field("closure_window_per_m", closure_window_per_m, share);
    visitor.field("closure_window_max_m", closure_window_max_m, length_m);
    visitor.field("closure_window_rad", closure_window_rad, angle_rad);
    visitor.field("closure_window_rad_per_m", closure_window_rad_per_m, share);
    visitor.field("closure_window_max_rad", closure_window_max_rad, angle_rad);
    visitor.field("closure_score", closure_score, share);
    visitor.field("closure_margin", closure_margin, share);
    visitor.field("closure_matched", closure_matched, share);
    visitor.field("closure_far_m", closure_far_m, length_m);
    visitor.field("closure_agreement_m", closure_agreement_m, length_m);
    visitor.field("closure_agreement_rad", closure_agreement_rad, angle_rad);
    visitor.field("closure_loss", closure_loss, Range{0.1, 1000.0});
    visitor.field("closure_reject", closure_reject, Range{1.0, 1000.0});
    visitor.field("refine_rounds", refine_rounds, Range{0, 10});
    visitor.field("refine_reach_m", refine_reach_m, length_m);
    visitor.field("refine_neighbours", refine_neighbours, Range{0, 100});
    visitor.field("refine_matched", refine_matched, share);
    visitor.field("refine_loss", refine_loss, Range{0.1, 1000.0});
    visitor.field("resolution_m", resolution_m, Range{0.01, 1.0});
    visitor.field("occupied_share", occupied_share, Range{0.01, 0.99});
    visitor.field("margin_m", margin_m, Range{0.0, 10.0});
  }
};

}  // namespace tandem
