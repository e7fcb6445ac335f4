#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace tandem::simulator {

/// How a piece of simulated hardware fails; may be switched at any time.
enum class HardwareFault : std::uint8_t {
  None,
  Off,           ///< no power
  Stuck,         ///< says the same again and again
  Garbage,       ///< says nothing that makes sense
  Wrong,         ///< says what is not true, in good form
  Slow,          ///< says it seldom
  Delayed,       ///< says it late
  Intermittent,  ///< is there, and is not
};

inline constexpr std::array<std::pair<std::string_view, HardwareFault>, 8> kHardwareFaultWords{{
    {"none", HardwareFault::None},
    {"off", HardwareFault::Off},
    {"stuck", HardwareFault::Stuck},
    {"garbage", HardwareFault::Garbage},
    {"wrong", HardwareFault::Wrong},
    {"slow", HardwareFault::Slow},
    {"delayed", HardwareFault::Delayed},
    {"intermittent", HardwareFault::Intermittent},
}};

/// The fault that `word` names.
[[nodiscard]] constexpr std::optional<HardwareFault> hardware_fault(std::string_view word) {
  for (const auto& [name, fault] : kHardwareFaultWords) {
    if (name == word) return fault;
  }
  return std::nullopt;
}

}  // namespace tandem::simulator
