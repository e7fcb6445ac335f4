#include "services/planner/core/planners/registry.hpp"

#include <functional>
#include <map>

#include "services/common/config.hpp"
#include "services/planner/core/planners/planner_options.hpp"
#include "services/planner/core/team/team_planner.hpp"

namespace tandem {
namespace {

using Make = std::function<std::unique_ptr<Planner>(PlannerOptions&)>;

std::unique_ptr<Planner> make_tandem(PlannerOptions& given) {
  TeamPlannerOptions options;
  options.eligible = given.whole_number("eligible", options.eligible);
  options.exploration = given.number("exploration", options.exploration);
  options.rollout_spread = given.number("rollout_spread", options.rollout_spread);
  return std::make_unique<TeamPlanner>(options);
}

const std::map<std::string, Make>& makers() {
  static const std::map<std::string, Make> all{{"tandem", make_tandem}};
  return all;
}

}  // namespace

std::vector<std::string> planner_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : makers()) names.push_back(name);
  return names;
}

std::unique_ptr<Planner> make_planner(std::string_view description) {
  PlannerOptions options(description);
  const auto maker = makers().find(options.name());
  if (maker == makers().end()) {
    std::string known;
    for (const auto& name : planner_names()) known += (known.empty() ? "" : ", ") + name;
    throw ConfigError("there is no planner '" + options.name() + "'; there are: " + known);
  }
  auto planner = maker->second(options);
  options.refuse_unknown();
  return planner;
}

}  // namespace tandem
