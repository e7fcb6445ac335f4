#include "robot/safety/core/link_monitor.hpp"

namespace tandem::safety {

Causes LinkMonitor::step(const LinkInput& link, const Pose2& odom_from_base, Time now) {
  const bool up = link.silent_s && *link.silent_s <= config_.link_timeout_s;
  const double step_m = (odom_from_base.position() - last_odom_.position()).norm();
  last_odom_ = odom_from_base;
  was_up_ = was_up_ || up;
  if (up) {
    lost_at_.reset();
    way_m_ = 0.0;
  } else if (!lost_at_) {
    lost_at_ = now;
  } else {
    way_m_ += step_m;
  }
  on_last_leg_ = !up && was_up_ && link.may_go_on && way_m_ <= config_.last_leg_m &&
                 now - *lost_at_ <= from_seconds(config_.last_leg_s);
  Causes causes;
  if (!config_.require_link || on_last_leg_) return causes;
  causes.set(index_of(Cause::LinkLost), !up);
  causes.set(index_of(Cause::LinkLongLost), was_up_ && !(link.silent_s && *link.silent_s <= config_.link_latch_s));
  return causes;
}

}  // namespace tandem::safety
