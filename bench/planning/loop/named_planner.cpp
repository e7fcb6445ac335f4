#include "bench/planning/loop/named_planner.hpp"

#include "services/planner/core/planners/registry.hpp"
#include "services/planner/remote/remote_planner.hpp"

namespace tandem::bench {

std::unique_ptr<Planner> named_planner(const std::string& description, double budget_s) {
  constexpr std::string_view kProgram = "exec:";
  if (!description.starts_with(kProgram)) return make_planner(description);
  RemotePlannerOptions options;
  options.command = description.substr(kProgram.size());
  options.budget_s = budget_s;
  return std::make_unique<RemotePlanner>(options);
}

}  // namespace tandem::bench
