#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// The planner that `description` names: a name of planner_names(), perhaps with options:
/// `tandem:eligible=6,exploration=0.5`. Throws ConfigError on an unknown name or option, and says which there are.
[[nodiscard]] std::unique_ptr<Planner> make_planner(std::string_view description);

/// What make_planner() knows.
[[nodiscard]] std::vector<std::string> planner_names();

}  // namespace tandem
