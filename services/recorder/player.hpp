#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/payload_type.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/replay_plan.hpp"

namespace tandem::recorder {

class LockstepPeer;

/// Sends a recording's messages again, payloads and source stamps as recorded, with the clock topic as their time.
class Player {
 public:
  /// Throws std::runtime_error when there is nothing to play, or when a base is connected to the domain of `bus`: a
  /// replay beside a real robot is refused.
  Player(mcap::Reader& reader, bus::Bus& bus, ReplayOptions options);

  /// Called some times a second with the share played [0, 1]. Pause and Step are for a replay at a rate; others play
  /// on.
  using Steer = std::function<ReplayWish(double share)>;
  /// In lockstep: each pose that came back for a scan, in order.
  using OnPose = std::function<void(const msg::RobotPose& pose)>;

  /// Plays to the end, or for ever with `loop`. Returns the number of messages sent.
  ///
  /// In lockstep it throws std::runtime_error when localization is not there or does not answer a scan.
  std::uint64_t play(const Steer& steer, const OnPose& on_pose);

 private:
  /// A topic that is played, and how to find the key of its payloads.
  struct Output {
    std::string name;  ///< of the topic it is sent on
    const TopicInfo* info = nullptr;
    bus::PayloadType type;
    std::unique_ptr<bus::RawWriter> writer;
  };

  /// What one run through the recording is given.
  struct Pass {
    const Steer& steer;
    const OnPose& on_pose;
    LockstepPeer* peer = nullptr;  ///< none at free rate
    std::size_t end = 0;           ///< the first message that is not played
    double share = 0.0;            ///< of the recording, played so far
    [[nodiscard]] bool is_to_end() const { return steer(share) == ReplayWish::End; }
  };

  /// False: it was told to end.
  bool play_once(std::size_t first, Time begin, Pass pass);
  /// In lockstep: sends the scan once all before it has arrived, and waits for its pose.
  void send_scan(const mcap::Message& message, Output& output, const Pass& pass);
  void refuse_beside_a_base();
  void make_outputs();
  [[nodiscard]] Output* output_of(std::uint16_t channel_id);
  void send(const mcap::Message& message, Output& output);
  void send_latched_before(std::size_t first);
  void send_clock(Time time, double rate);
  [[nodiscard]] std::unique_ptr<bus::RawWriter> writer_of(const Output& output);
  /// The index of the first message logged at `time` or later.
  [[nodiscard]] std::size_t first_at(Time time) const;
  /// Sleeps until the message logged at `logged` is due, telling the time meanwhile. False: the replay is to end.
  bool wait_until_due(Time logged, ReplayPace& pace, const Pass& pass);

  mcap::Reader& reader_;
  bus::Bus& bus_;
  ReplayOptions options_;
  bus::Writer<msg::Clock, msg::ClockPubSubType> clock_;
  std::map<std::string, Output> outputs_;                ///< by recorded topic
  std::map<std::uint16_t, std::string> channel_topics_;  ///< of the channels that are played
  std::set<std::uint16_t> disposed_channels_;
  std::uint32_t epoch_ = 0;
  std::uint64_t sent_ = 0;
};

}  // namespace tandem::recorder
