#pragma once

#include "services/common/config.hpp"

namespace tandem::tracking {

/// config/<place>/robot/tracker.toml.
struct TrackingConfig {
  // From a scan to legs.
  double max_range_m = 10.0;    ///< Beyond, a leg is less than a beam wide.
  double cluster_gap_m = 0.12;  ///< Neighbouring beams farther apart belong to different things.
  double min_leg_width_m = 0.03;
  double max_leg_width_m = 0.28;
  double max_body_width_m = 0.7;  ///< Legs side by side, a skirt, a coat.
  double leg_depth_m = 0.04;      ///< From what is seen of a leg to its middle.
  double map_margin_m = 0.2;      ///< What is as close to a wall of the map is that wall.
  double max_stride_m = 0.8;      ///< Between the legs of one person.

  // From legs to people.
  double pair_deviation_m = 0.08;          ///< Of a person seen with both legs from the middle of the body,
  double single_deviation_m = 0.16;        ///< and with one.
  double acceleration_mps2 = 1.0;          ///< How people change their velocity: white noise acceleration.
  double first_speed_deviation_mps = 0.8;  ///< Of someone seen for the first time.
  double gate = 9.21;                      ///< Squared Mahalanobis distance: 99 % of the sightings of a track.
  double min_separation_m = 0.5;           ///< A sighting so close to a track is no new person.
  std::int64_t hits_to_confirm = 3;
  double tentative_s = 0.35;  ///< Unseen for so long, a track that is not confirmed ends,
  double lose_after_s = 1.5;  ///< and one that is.
  double moved_m = 0.3;       ///< One leg alone is a person when it has walked so far.

  // The teammate.
  double message_deviation_m = 0.7;  ///< Of a person's finger on the map.
  double message_gate_m = 2.0;       ///< *My pose* names the nearest track within this,
  double keep_gate_m = 3.0;          ///< unless the one it had is within this.
  double renaming_evidence = 2.0;    ///< unless another is likelier by e to this power.
  double message_max_age_s = 3.0;    ///< Older ones say where the person was, not where they are: refused.
  double sighted_s = 0.5;            ///< A track unseen for longer is not a sighting any more.
  double message_s = 1.0;            ///< A message is what it says for this long; then we predict.
  double lost_after_s = 10.0;
  double coast_s = 1.5;  ///< Without a plan people go on for this long as they went.
  double uncertainty_growth_mps = 0.5;
  double reach_limit_m = 3.0;       ///< A new track farther from the prediction is somebody else.
  double certainty = 0.75;          ///< How likely a new track must be the teammate among all that could be.
  bool follow_plan = true;          ///< Predict along the person's path of the accepted plan,
  double walking_speed_mps = 0.75;  ///< at this speed,
  double plan_distance_m = 2.0;     ///< if the person was this close to it.

  // The service.
  double pose_wait_s = 0.25;  ///< A scan waits this long for the pose of its time.
  double max_extrapolation_s = 0.2;
  double people_period_s = 0.1;
  double teammates_period_s = 0.2;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("max_range_m", max_range_m, Range{1.0, 50.0});
    visitor.field("cluster_gap_m", cluster_gap_m, Range{0.02, 1.0});
    visitor.field("min_leg_width_m", min_leg_width_m, Range{0.0, 0.2});
    visitor.field("max_leg_width_m", max_leg_width_m, Range{0.1, 0.6});
    visitor.field("max_body_width_m", max_body_width_m, Range{0.2, 1.5});
    visitor.field("leg_depth_m", leg_depth_m, Range{0.0, 0.2});
    visitor.field("map_margin_m", map_margin_m, Range{0.0, 1.0});
    visitor.field("max_stride_m", max_stride_m, Range{0.2, 1.5});
    visitor.field("pair_deviation_m", pair_deviation_m, Range{0.01, 1.0});
    visitor.field("single_deviation_m", single_deviation_m, Range{0.01, 1.0});
    visitor.field("acceleration_mps2", acceleration_mps2, Range{0.1, 10.0});
    visitor.field("first_speed_deviation_mps", first_speed_deviation_mps, Range{0.1, 5.0});
    visitor.field("gate", gate, Range{1.0, 50.0});
    visitor.field("min_separation_m", min_separation_m, Range{0.0, 2.0});
    visitor.field("hits_to_confirm", hits_to_confirm, Range{1, 50});
    visitor.field("tentative_s", tentative_s, Range{0.05, 5.0});
    visitor.field("lose_after_s", lose_after_s, Range{0.1, 10.0});
    visitor.field("moved_m", moved_m, Range{0.0, 5.0});
    visitor.field("message_deviation_m", message_deviation_m, Range{0.05, 5.0});
    visitor.field("message_gate_m", message_gate_m, Range{0.1, 10.0});
    visitor.field("keep_gate_m", keep_gate_m, Range{0.1, 10.0});
    visitor.field("renaming_evidence", renaming_evidence, Range{0.0, 20.0});
    visitor.field("message_max_age_s", message_max_age_s, Range{0.5, 60.0});
    visitor.field("sighted_s", sighted_s, Range{0.1, 5.0});
    visitor.field("message_s", message_s, Range{0.1, 10.0});
    visitor.field("lost_after_s", lost_after_s, Range{1.0, 120.0});
    visitor.field("coast_s", coast_s, Range{0.0, 10.0});
    visitor.field("uncertainty_growth_mps", uncertainty_growth_mps, Range{0.05, 3.0});
    visitor.field("reach_limit_m", reach_limit_m, Range{0.5, 20.0});
    visitor.field("certainty", certainty, Range{0.5, 1.0});
    visitor.field("follow_plan", follow_plan);
    visitor.field("walking_speed_mps", walking_speed_mps, Range{0.1, 3.0});
    visitor.field("plan_distance_m", plan_distance_m, Range{0.1, 10.0});
    visitor.field("pose_wait_s", pose_wait_s, Range{0.0, 1.0});
    visitor.field("max_extrapolation_s", max_extrapolation_s, Range{0.0, 1.0});
    visitor.field("people_period_s", people_period_s, Range{0.05, 1.0});
    visitor.field("teammates_period_s", teammates_period_s, Range{0.05, 1.0});
  }
};

}  // namespace tandem::tracking
