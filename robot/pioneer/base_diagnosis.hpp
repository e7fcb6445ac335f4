#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/safety/core/safety_gate.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// Judges, from one cycle to the next, whether a base that works works well.
class BaseDiagnosis {
 public:
  /// What is to be looked at: the gate's input and decision, the line's wrong checksums since the start, and the
  /// deceleration that the controller was asked for.
  struct Signs {
    const safety::BaseInput& base;
    const safety::GateDecision& decision;
    std::uint64_t bad_checksums = 0;
    double asked_deceleration_mps2 = 0.0;
  };
  /// What somebody should do about it, most urgent first; empty if all is well.
  [[nodiscard]] std::string step(const Signs& signs, Time now);

 private:
  [[nodiscard]] bool line_is_bad(std::uint64_t bad_checksums, Time now);
  [[nodiscard]] bool motors_refuse(const Signs& signs, Time now);

  std::optional<Time> refused_since_;
  Time window_began_{};
  std::uint64_t bad_at_begin_ = 0;
  bool line_is_bad_ = false;
};

}  // namespace tandem
