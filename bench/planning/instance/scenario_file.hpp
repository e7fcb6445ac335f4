#pragma once

#include <string>

#include "bench/planning/instance/families.hpp"

namespace tandem::bench {

/// The instance as a planning scenario (config/scenarios/planning.schema.json), for `tandem plan` and for planners that
/// read files. First sight is written as a rate of 1000 per second; what happens on the way (S5, S6) has no place in
/// it.
[[nodiscard]] std::string scenario_json(const PlanningInstance& instance);

}  // namespace tandem::bench
