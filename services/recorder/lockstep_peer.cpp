#include "services/recorder/lockstep_peer.hpp"

#include <stdexcept>

namespace tandem::recorder {
namespace {

constexpr Duration kDiscovery = std::chrono::seconds{10};
constexpr Duration kFirstAnswer = std::chrono::seconds{30};  ///< the map may still be on its way
constexpr Duration kAnswer = std::chrono::seconds{5};

}  // namespace

LockstepPeer::LockstepPeer(bus::Bus& bus) : bus_(bus), poses_(bus.in_order(topic::kRobotPose)) {
  if (!bus::wait_until(bus_, kDiscovery, [this] { return poses_.matched_writers() > 0; })) {
    throw std::runtime_error(
        "nobody writes robot_pose in this DDS domain: start `tandem-localization --lockstep` (and `tandem-map-server`) "
        "before a lockstep replay");
  }
}

void LockstepPeer::expect_delivery(bus::RawWriter& writer, const std::string& topic) {
  if (writer.wait_for_acknowledgments(kAnswer)) return;
  throw std::runtime_error(topic +
                           " was not taken by all its readers within 5 s: is a service of this DDS domain stuck?");
}

msg::RobotPose LockstepPeer::pose_of(std::int64_t stamp_ns, const std::function<bool()>& keep_going) {
  const auto has_answer = [&] {
    for (auto& received : poses_.take()) arrived_.push_back(std::move(received.message));
    while (!arrived_.empty() && arrived_.front().stamp_ns() < stamp_ns) arrived_.pop_front();
    return !arrived_.empty() && arrived_.front().stamp_ns() == stamp_ns;
  };
  bool going = true;
  const Duration patience = answered_before_ ? kAnswer : kFirstAnswer;
  const bool answered = bus::wait_until(bus_, patience, [&] { return has_answer() || !(going = keep_going()); });
  if (!answered || !going) {
    throw std::runtime_error("tandem-localization gave no robot_pose for the scan of stamp " +
                             std::to_string(stamp_ns) + " ns" +
                             (going ? " within " + std::to_string(patience / std::chrono::seconds{1}) + " s" : ""));
  }
  answered_before_ = true;
  msg::RobotPose pose = std::move(arrived_.front());
  arrived_.pop_front();
  return pose;
}

}  // namespace tandem::recorder
