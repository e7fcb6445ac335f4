#include "robot/safety/core/odometry_trail.hpp"

namespace tandem::safety {

void OdometryTrail::take(const Pose2& odom_from_base, std::uint32_t epoch, Time now) {
  if (epoch != epoch_) count_ = 0;
  epoch_ = epoch;
  newest_ = (newest_ + 1) % ring_.size();
  ring_[newest_] = {odom_from_base, now};
  if (count_ < ring_.size()) ++count_;
}

Pose2 OdometryTrail::moved_on(const Pose2& map_from_base, Time stamp) const {
  const Pose2& latest = ring_[newest_].odom_from_base;
  for (std::size_t back = 0; back < count_; ++back) {
    const Entry& entry = ring_[(newest_ + ring_.size() - back) % ring_.size()];
    if (entry.at <= stamp) return map_from_base * inverse(entry.odom_from_base) * latest;
  }
  return map_from_base;
}

}  // namespace tandem::safety
