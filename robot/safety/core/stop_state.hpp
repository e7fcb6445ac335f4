#pragma once

#include <optional>
#include <string_view>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// Remembers stops until they are over: automatic ones for some healthy seconds, latched ones until somebody resumes.
class StopState {
 public:
  explicit StopState(const GateConfig& config) : config_(config) {}

  /// Takes the causes that hold at `now`; those of kind AtOnce are not remembered. `excusable` are those that somebody
  /// may resume from while they hold; one that was excused stays so until it is over.
  void step(const Causes& holding, Time now, const Causes& excusable = {});
  /// Asks to go on; empty if granted, else why not. Motion follows after the warning.
  [[nodiscard]] std::string_view resume(double held_s, Time now);

  [[nodiscard]] bool may_move(Time now) const;
  [[nodiscard]] bool is_latched() const { return latched_.any(); }
  /// Causes that hold, or held and were not resumed.
  [[nodiscard]] Causes open_causes() const { return holding_ | latched_ | excused_; }
  /// Causes that hold and that somebody resumed from.
  [[nodiscard]] const Causes& excused() const { return excused_; }
  /// Time until motion comes back, if nothing happens; 0 when it may move, or waits for a cause or a person [s].
  [[nodiscard]] double resume_in_s(Time now) const;

 private:
  const GateConfig& config_;
  Causes holding_;
  Causes latched_;
  Causes excusable_;
  Causes excused_;
  std::optional<Time> free_at_;  ///< when the pause after the last stop ends; none while a cause holds or is latched
  bool stopped_ = false;
};

}  // namespace tandem::safety
