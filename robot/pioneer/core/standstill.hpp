#pragma once

#include "robot/pioneer/core/packet.hpp"

namespace tandem::pioneer {

/// What makes a connected controller stand still and forget the speed it was last given, whoever said it: both
/// velocities 0, then STOP. Without the first two it would drive on after its watchdog (protocol page, "revive").
[[nodiscard]] inline Bytes standstill_commands() {
  Bytes bytes;
  for (const auto& packet : {command(Command::Velocity, 0), command(Command::TurnRate, 0), command(Command::Stop)}) {
    bytes.insert(bytes.end(), packet.begin(), packet.end());
  }
  return bytes;
}

}  // namespace tandem::pioneer
