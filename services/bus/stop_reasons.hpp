#pragma once

#include <string>

#include "idl/topics.hpp"

namespace tandem::bus {

/// A reason to stand still, in words for people: "a wheel is blocked".
[[nodiscard]] std::string words_of(msg::StopReason reason);

}  // namespace tandem::bus
