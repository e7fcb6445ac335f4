#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "services/common/time.hpp"
#include "services/localization/core/localizer.hpp"

namespace tandem {

/// Where the robot was on which map, as it is kept over a restart.
struct LastPose {
  Time time{};
  std::string map_sha256;
  RememberedPose pose;
};

/// As one line of JSON.
[[nodiscard]] std::string to_text(const LastPose& last);

/// What to do with a kept pose.
struct MemoryUse {
  RememberedPose pose;
  Memory memory = Memory::Old;
};

/// When a kept pose is of use.
struct MemoryRule {
  std::string map_sha256;  ///< of the map that is used now
  Time now{};
  Duration fresh{};    ///< At most this old: Memory::Fresh.
  Duration max_age{};  ///< Older: of no use.
};

/// The pose that `text` keeps, or why it is of no use: not what to_text() writes, of another map, too old, or from the
/// future.
[[nodiscard]] std::variant<MemoryUse, std::string> memory_of(std::string_view text, const MemoryRule& rule);

}  // namespace tandem
