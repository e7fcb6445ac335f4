#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// Whether the description is `exec:COMMAND`, a planner that is another program.
[[nodiscard]] bool is_other_program(std::string_view description);

/// A planner by its name and options (`tandem:eligible=6`), or another program (`exec:COMMAND`,
/// docs/planner_protocol.md) that is told it may take `budget_s` for a plan. Throws ConfigError on an unknown name.
[[nodiscard]] std::unique_ptr<Planner> named_planner(const std::string& description, double budget_s);

}  // namespace tandem
