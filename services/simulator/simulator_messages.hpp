#pragma once

#include <systemPubSubTypes.h>

#include <string>

#include "services/simulator/core/simulation.hpp"

namespace tandem::simulator {

/// What is true at `now`, for recorder and tests; `robot` and `agent` are the names others know them by.
[[nodiscard]] msg::GroundTruth ground_truth_message(const Simulation& simulation, const std::string& robot,
                                                    const std::string& agent, Time now);

}  // namespace tandem::simulator
