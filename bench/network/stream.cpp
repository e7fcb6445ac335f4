#include "bench/network/stream.hpp"

namespace tandem::bench {
namespace {

template <class PubSubType>
bus::KeyHash key_of_robot() {
  typename PubSubType::type message;
  message.robot("robot1");
  return bus::key_of<PubSubType>(message);
}

}  // namespace

Stream::Stream(Side& side, const TopicInfo& topic, double rate_hz, Payload payload, const bus::KeyHash& key)
    : writer_(side.writer(topic)), thread_([this, rate_hz, payload = std::move(payload), key] {
        SteadyClock clock;
        for (Metronome beat{clock, from_seconds(1.0 / rate_hz)}; !ended_; beat.wait([this] { return ended_.load(); })) {
          writer_->write(payload(sent_, clock.now()), key);
          ++sent_;
        }
      }) {}

Stream::~Stream() {
  ended_ = true;
  thread_.join();
}

std::unique_ptr<Stream> pose_stream(Side& side, double rate_hz) {
  return std::make_unique<Stream>(
      side, info_of(topic::kRobotPose), rate_hz,
      [](std::uint64_t number, Time now) {
        msg::RobotPose pose;
        pose.robot("robot1");
        pose.odometry_epoch(static_cast<std::uint32_t>(number));
        pose.stamp_ns(to_stamp_ns(now));
        return bus::encode<msg::RobotPosePubSubType>(pose);
      },
      key_of_robot<msg::RobotPosePubSubType>());
}

std::unique_ptr<Stream> plan_stream(Side& side, double rate_hz) {
  return std::make_unique<Stream>(
      side, info_of(topic::kTeamPlan), rate_hz,
      [](std::uint64_t number, Time now) {
        msg::TeamPlan plan;
        plan.robot("robot1");
        plan.sequence_number(number);
        plan.stamp_ns(to_stamp_ns(now));
        return bus::encode<msg::TeamPlanPubSubType>(plan);
      },
      key_of_robot<msg::TeamPlanPubSubType>());
}

std::unique_ptr<Stream> odometry_stream(Side& side, double rate_hz) {
  return std::make_unique<Stream>(
      side, info_of(topic::kOdometry), rate_hz,
      [](std::uint64_t, Time now) {
        msg::Odometry odometry;
        odometry.robot("robot1");
        odometry.stamp_ns(to_stamp_ns(now));
        return bus::encode<msg::OdometryPubSubType>(odometry);
      },
      key_of_robot<msg::OdometryPubSubType>());
}

void pause(Duration duration) {
  SteadyClock clock;
  clock.wait_until(clock.now() + duration, {});
}

bool holds_within(Duration timeout, const std::function<bool()>& condition) {
  const SteadyClock clock;
  for (const Time end = clock.now() + timeout; !condition();) {
    if (clock.now() > end) return false;
    pause(std::chrono::milliseconds{1});
  }
  return true;
}

double ms_to_next_pose(Listener& listener, Duration patience) {
  const Time began = SteadyClock{}.now();
  double ms = kNever;
  holds_within(patience, [&] {
    ms = ms_to_first<msg::RobotPosePubSubType>(listener, began);
    return ms < kNever;
  });
  return ms;
}

}  // namespace tandem::bench
