#pragma once

#include <optional>

#include "idl/topics.hpp"
#include "services/planner/core/mission/search_mission.hpp"

namespace tandem {

// What a person says and draws, from the bus; what is not usable is none. A place is an outline of three corners or
// more, or a single point: the disc of 1 m around it.

[[nodiscard]] std::optional<BeliefEdit> to_core(const msg::BeliefEdit& message);
[[nodiscard]] std::optional<SourceEdit> to_core(const msg::SourceEdit& message);

}  // namespace tandem
