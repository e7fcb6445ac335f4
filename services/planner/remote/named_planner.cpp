#include "services/planner/remote/named_planner.hpp"

#include "services/planner/core/planners/registry.hpp"
#include "services/planner/remote/remote_planner.hpp"

namespace tandem {
namespace {

constexpr std::string_view kProgram = "exec:";

}  // namespace

bool is_other_program(std::string_view description) {
  return description.starts_with(kProgram);
}

std::unique_ptr<Planner> named_planner(const std::string& description, double budget_s) {
  if (!is_other_program(description)) return make_planner(description);
  RemotePlannerOptions options;
  options.command = description.substr(kProgram.size());
  options.budget_s = budget_s;
  return std::make_unique<RemotePlanner>(options);
}

}  // namespace tandem
