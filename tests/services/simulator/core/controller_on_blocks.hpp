#pragma once

#include <gtest/gtest.h>

#include "services/simulator/core/pioneer_firmware.hpp"

namespace tandem::simulator {

/// A controller on blocks: its wheels turn freely, time goes in steps of 25 ms.
class OnBlocks {
 public:
  static constexpr Duration kStep = std::chrono::milliseconds{25};

  explicit OnBlocks(Duration watchdog = std::chrono::milliseconds{500}) : OnBlocks(options(watchdog)) {}
  explicit OnBlocks(const FirmwareOptions& options) : firmware(options, now) {}

  static FirmwareOptions options(Duration watchdog = std::chrono::milliseconds{500}) {
    FirmwareOptions options;
    options.parameters = *pioneer::robot_parameters("p2at");
    options.watchdog = watchdog;
    return options;
  }

  pioneer::Bytes send(const pioneer::Bytes& bytes) { return firmware.receive(bytes, now); }
  void open() {
    using pioneer::Command;
    for (const auto sync : {Command::Pulse, Command::Open, Command::Close}) (void)send(pioneer::command(sync));
    (void)send(pioneer::command(Command::Open));
  }
  /// Lets `seconds` pass; with `pulse` the host keeps the watchdog quiet.
  void run(double seconds, bool pulse, const Moved& moved = {}) {
    for (const Time end = now + from_seconds(seconds); now < end;) {
      now += kStep;
      if (pulse) (void)send(pioneer::command(pioneer::Command::Pulse));
      const Pose2 motion = arc(firmware.drive(to_seconds(kStep), now), to_seconds(kStep));
      firmware.settle(motion, moved, now);
    }
  }
  /// All packets of the report that is due.
  std::vector<pioneer::Packet> report() {
    pioneer::PacketReceiver receiver;
    receiver.push(firmware.report({}, now), now);
    std::vector<pioneer::Packet> packets;
    while (auto packet = receiver.next()) packets.push_back(*packet);
    return packets;
  }
  pioneer::Sip sip() { return *pioneer::decode_sip(report().front()); }

  Time now{};
  PioneerFirmware firmware;
};

}  // namespace tandem::simulator
