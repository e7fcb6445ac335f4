#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/packet.hpp"
#include "robot/pioneer/core/sip.hpp"

namespace tandem::pioneer {

/// A small Pioneer: handshake, watchdog, and the last speed that comes back by itself.
class FakeController {
 public:
  void receive(const Bytes& bytes, Time now) {
    receiver_.push(bytes, now);
    while (const auto packet = receiver_.next()) {
      if (powered) take(*packet, now);
    }
  }
  /// What it has to say at `now`: replies, and a status every 100 ms once it is open.
  Bytes step(Time now) {
    if (!powered) return {};
    if (open && now - last_command_ > watchdog) {
      watchdog_fired = true;
      actual_mmps = 0;
    }
    travelled_mm += std::abs(actual_mmps) * to_seconds(now - last_step_);
    last_step_ = now;
    if (open && now - last_status_ >= std::chrono::milliseconds{100} && !silent) {
      last_status_ = now;
      Sip sip = status;
      sip.flags = static_cast<std::uint16_t>(status.flags | (motors ? sip_flag::kMotorsEnabled : 0));
      sip.x = static_cast<std::uint16_t>(static_cast<int>(travelled_mm / 1.32) & 0x7FFF);  // as a p2at counts
      sip.left_velocity = sip.right_velocity = static_cast<std::int16_t>(actual_mmps);
      const Bytes bytes = framed(encode_sip(sip));
      output_.insert(output_.end(), bytes.begin(), bytes.end());
    }
    return std::exchange(output_, {});
  }
  void power_cycle() {
    open = motors = false;
    stage_ = 0;
    actual_mmps = commanded_mmps = 0;
    seen.clear();
  }
  [[nodiscard]] bool saw(Command command) const {
    return std::any_of(seen.begin(), seen.end(),
                       [&](const HostCommand& one) { return one.number == static_cast<std::uint8_t>(command); });
  }
  [[nodiscard]] std::optional<int> newest(Command command) const {
    for (auto one = seen.rbegin(); one != seen.rend(); ++one) {
      if (one->number == static_cast<std::uint8_t>(command)) return one->integer_or(0);
    }
    return std::nullopt;
  }

  bool powered = true;
  bool open = false;
  bool motors = false;
  bool silent = false;
  bool watchdog_fired = false;
  int commanded_mmps = 0;
  int actual_mmps = 0;
  double travelled_mm = 0.0;
  Duration watchdog = std::chrono::milliseconds{2000};
  Sip status;
  ConfigPacket config;
  std::vector<HostCommand> seen;
  std::optional<Packet> answer_to_sync;  ///< instead of the right one, once

 private:
  void take(const Packet& packet, Time now) {
    const auto command = decode_command(packet);
    if (!command) return;
    last_command_ = now;
    seen.push_back(*command);
    if (!open && command->number <= 2) {
      sync(command->number);
      if (open) last_status_ = now;
      return;
    }
    if (!open) return;
    switch (static_cast<Command>(command->number)) {
      case Command::Close:
        open = motors = false;
        stage_ = 0;
        break;
      case Command::Velocity:
        commanded_mmps = command->integer_or(0);
        break;
      case Command::Enable:
        motors = command->integer_or(0) != 0 && !status.stop_pressed();
        break;
      case Command::Config:
        reply({encode_config(config)});
        break;
      case Command::SetTranslationalAcceleration: {
        const int value = command->integer_or(0);
        (value > 0 ? config.acceleration : config.deceleration) = static_cast<std::uint16_t>(std::abs(value));
        break;
      }
      default:
        break;
    }
    actual_mmps = motors ? commanded_mmps : 0;  // at any packet: the last speed comes back
  }
  void sync(int number) {
    if (answer_to_sync) {
      reply(*std::exchange(answer_to_sync, {}));
      return;
    }
    if (number == 1 && stage_ == 3) {  // OPEN
      open = true;
      return;
    }
    if (number != stage_) {
      stage_ = number == 0 ? 1 : 0;
      if (number == 0) reply({0, {}});
      return;
    }
    reply(number == 2 ? encode_identity({"Tibi", "Pioneer", "p2at"}) : Packet{static_cast<std::uint8_t>(number), {}});
    ++stage_;
  }
  void reply(const Packet& packet) {
    const Bytes bytes = framed(packet);
    output_.insert(output_.end(), bytes.begin(), bytes.end());
  }

  PacketReceiver receiver_;
  Bytes output_;
  int stage_ = 0;
  Time last_command_{};
  Time last_status_{};
  Time last_step_{};
};

}  // namespace tandem::pioneer
