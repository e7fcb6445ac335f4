#pragma once

#include <optional>
#include <string>

#include "gateway/protocol/messages.hpp"

namespace tandem::gateway {

/// Why `role` may not do `kind` now, for people; none when it may. The one table of who may do what.
///
/// Everybody may stop the robot, an observer too: it is always the safe thing.
[[nodiscard]] std::optional<std::string> refusal_of(protocol::UserRole role, protocol::CommandKind kind,
                                                    bool search_is_running);

/// How long Resume must have been held [ms].
inline constexpr double kResumeHoldMs = 1000.0;
/// A pose older than this is history, not where the person is [ms].
inline constexpr double kPoseLifeMs = 3000.0;
/// What else is older than this may not be wanted any more [ms].
inline constexpr double kWishLifeMs = 15'000.0;

/// Why `command` is refused for what it is, whoever sends it: too old, not held long enough. Stop never is, nor is
/// what only tells what happened on the phone.
[[nodiscard]] std::optional<std::string> refusal_of(const protocol::Command& command);

}  // namespace tandem::gateway
