#include "robot/camera/core/pose_history.hpp"

#include <algorithm>
#include <iterator>

namespace tandem {
namespace {

constexpr std::size_t kMostEntries = 200;  // 10 s at 20 Hz
constexpr Duration kMostBetween = std::chrono::seconds{1};

}  // namespace

void PoseHistory::add(const Entry& entry) {
  if (!entries_.empty() && entry.stamp <= entries_.back().stamp) return;
  entries_.push_back(entry);
  if (entries_.size() > kMostEntries) entries_.pop_front();
}

std::optional<PoseHistory::Entry> PoseHistory::at(Time time) const {
  const auto after = std::lower_bound(entries_.begin(), entries_.end(), time,
                                      [](const Entry& entry, Time wanted) { return entry.stamp < wanted; });
  if (after == entries_.end()) return std::nullopt;
  if (after->stamp == time) return *after;
  if (after == entries_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const Duration between = after->stamp - before->stamp;
  if (between > kMostBetween) return std::nullopt;
  const double share = to_seconds(time - before->stamp) / to_seconds(between);
  return Entry{time, interpolate(before->map_from_base, after->map_from_base, share), after->covariance};
}

}  // namespace tandem
