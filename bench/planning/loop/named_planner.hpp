#pragma once

#include <memory>
#include <string>

#include "services/planner/core/team/planner.hpp"

namespace tandem::bench {

/// A planner by its name and options (`tandem:eligible=6`), or another program (`exec:COMMAND`,
/// docs/planner_protocol.md) that is told it may take `budget_s` for a plan. Throws ConfigError on an unknown name.
[[nodiscard]] std::unique_ptr<Planner> named_planner(const std::string& description, double budget_s);

}  // namespace tandem::bench
