#pragma once

#include <string>

#include "idl/topics.hpp"

namespace tandem {

/// Why the safety gate stops the robot, in a few words for people: "something is in the way".
[[nodiscard]] std::string words_of(msg::StopReason reason);

}  // namespace tandem
