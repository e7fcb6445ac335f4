#pragma once

#include <deque>
#include <optional>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// Where the robot was lately, for pictures that show what it saw a moment ago.
class PoseHistory {
 public:
  struct Entry {
    Time stamp{};
    Pose2 map_from_base;
    Covariance3 covariance = Covariance3::Zero();
  };

  /// Adds a pose; one not later than the last is left out.
  void add(const Entry& entry);
  /// Forgets everything: the pose was lost, or time began anew.
  void clear() { entries_.clear(); }
  /// The pose at `time`, between the two around it; none if they lie more than 1 s apart, or `time` outside all of
  /// them.
  [[nodiscard]] std::optional<Entry> at(Time time) const;
  /// True if at(time) cannot yet be known but may be soon: `time` is after the last pose.
  [[nodiscard]] bool is_after_last(Time time) const { return entries_.empty() || time > entries_.back().stamp; }

 private:
  std::deque<Entry> entries_;
};

}  // namespace tandem
