#pragma once

#include <deque>
#include <functional>
#include <string>

#include "services/bus/bus.hpp"

namespace tandem::recorder {

/// The other side of a lockstep replay, localization: what it was sent has arrived, and what it made of it comes back
/// before anything else is sent. Throws std::runtime_error, naming service and stamp, when it does not.
class LockstepPeer {
 public:
  explicit LockstepPeer(bus::Bus& bus);

  /// Waits until whatever `writer` sent has arrived at its readers.
  void expect_delivery(bus::RawWriter& writer, const std::string& topic);
  /// Waits for the pose of the scan stamped `stamp_ns`. `keep_going` false ends the wait, as an error.
  [[nodiscard]] msg::RobotPose pose_of(std::int64_t stamp_ns, const std::function<bool()>& keep_going);

 private:
  bus::Bus& bus_;
  bus::InOrder<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  std::deque<msg::RobotPose> arrived_;
  bool answered_before_ = false;
};

}  // namespace tandem::recorder
