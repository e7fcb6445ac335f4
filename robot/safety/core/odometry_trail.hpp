#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// Where the wheels said the robot was during the last seconds: carries a pose that is a little old on to now.
class OdometryTrail {
 public:
  /// Takes the odometry of `now`; a new `epoch` forgets the old one.
  void take(const Pose2& odom_from_base, std::uint32_t epoch, Time now);
  /// `map_from_base` of `stamp`, moved on by what the wheels have turned since; unmoved where that is not known.
  [[nodiscard]] Pose2 moved_on(const Pose2& map_from_base, Time stamp) const;

 private:
  struct Entry {
    Pose2 odom_from_base;
    Time at{};
  };
  std::array<Entry, 64> ring_{};  ///< three seconds at twenty a second
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
  std::uint32_t epoch_ = 0;
};

}  // namespace tandem::safety
