#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "robot/safety/core/swept_path.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// Identifies one running commander (a process), not its name.
using CommanderId = std::array<std::uint8_t, 16>;

/// Who commands decides what is allowed: an operator at the robot may drive back and without a pose.
enum class CommanderKind : std::uint8_t { Program, Operator };

/// A velocity command as it came, unchecked.
struct CommandSample {
  CommanderId commander{};
  CommanderKind kind = CommanderKind::Program;
  std::uint64_t sequence_number = 0;
  Motion motion;
};

/// Judges the commands: are they fresh, from one commander, and sane?
class CommandMonitor {
 public:
  explicit CommandMonitor(const GateConfig& config) : config_(config) {}

  /// Takes a command that arrived at `now`. One that is not sane, or older than the last of its commander, is counted
  /// or left out, and the last good one holds until it is stale.
  void take(const CommandSample& command, Time now);
  [[nodiscard]] Causes causes(Time now) const;
  /// What is asked for now: nothing once the last good command is stale.
  [[nodiscard]] Motion wanted(Time now) const;
  [[nodiscard]] CommanderKind kind() const { return kind_; }
  /// Commands rejected since the start.
  [[nodiscard]] std::uint64_t rejected() const { return rejected_; }
  /// Commanders heard within the command time-out.
  [[nodiscard]] int live_commanders(Time now) const;

 private:
  struct Commander {
    CommanderId id{};
    std::uint64_t sequence_number = 0;
    std::optional<Time> heard;
  };
  [[nodiscard]] bool is_fresh(Time now) const;

  const GateConfig& config_;
  std::array<Commander, 4> commanders_{};
  Motion motion_;
  CommanderKind kind_ = CommanderKind::Program;
  std::optional<Time> arrived_;
  std::array<std::optional<Time>, 4> rejections_{};  ///< the newest, a ring
  std::size_t next_rejection_ = 0;
  std::uint64_t rejected_ = 0;
};

}  // namespace tandem::safety
