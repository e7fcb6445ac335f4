#include "services/tracking/core/pose_history.hpp"

#include <algorithm>

namespace tandem::tracking {

void PoseHistory::add(Time stamp, const Pose2& pose) {
  if (!entries_.empty() && stamp <= entries_.back().stamp) return;
  entries_.push_back({stamp, pose});
  while (entries_.front().stamp < stamp - length_) entries_.pop_front();
}

bool PoseHistory::covers(Time time) const {
  return !entries_.empty() && entries_.front().stamp <= time && time <= entries_.back().stamp;
}

std::optional<Pose2> PoseHistory::at(Time time) const {
  if (entries_.empty() || time < entries_.front().stamp) return std::nullopt;
  const Entry& last = entries_.back();
  if (time > last.stamp + max_extrapolation_) return std::nullopt;
  const auto share = [time](const Entry& a, const Entry& b) {
    return to_seconds(time - a.stamp) / to_seconds(b.stamp - a.stamp);
  };
  if (time >= last.stamp) {
    if (entries_.size() < 2 || time == last.stamp) return last.pose;
    const Entry& before = entries_[entries_.size() - 2];
    return interpolate(before.pose, last.pose, share(before, last));
  }
  const auto after = std::upper_bound(entries_.begin(), entries_.end(), time,
                                      [](Time value, const Entry& entry) { return value < entry.stamp; });
  const auto before = std::prev(after);
  return interpolate(before->pose, after->pose, share(*before, *after));
}

}  // namespace tandem::tracking
