#pragma once

#include <optional>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// What the relay says of the link to the operator.
struct LinkInput {
  std::optional<double> silent_s;  ///< since the other side was heard; none if it never was
  bool may_go_on = false;          ///< the site lets the robot finish its leg, or retreat, without a link
};

/// Judges the link to the operator, whose STOP would not arrive without it.
class LinkMonitor {
 public:
  explicit LinkMonitor(const GateConfig& config) : config_(config) {}

  /// Takes the state of the link at `now`, and where the wheels say the robot is.
  Causes step(const LinkInput& link, const Pose2& odom_from_base, Time now);
  /// The link is gone, and the robot goes on for its last leg: slowly, so far and so long.
  [[nodiscard]] bool is_on_last_leg() const { return on_last_leg_; }

 private:
  const GateConfig& config_;
  bool was_up_ = false;
  bool on_last_leg_ = false;
  std::optional<Time> lost_at_;
  double way_m_ = 0.0;  ///< since then
  Pose2 last_odom_;
};

}  // namespace tandem::safety
