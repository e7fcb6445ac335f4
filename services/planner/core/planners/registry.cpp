#include "services/planner/core/planners/registry.hpp"

#include <map>

#include "services/common/config.hpp"
#include "services/planner/core/planners/peers.hpp"
#include "services/planner/core/team/tandem_planner.hpp"

namespace tandem {
namespace {

std::unique_ptr<Planner> make_tandem(PlannerOptions& given) {
  TandemOptions options;
  given.read("eligible", options.tree.eligible);
  given.read("exploration", options.tree.exploration);
  given.read("rollout_spread", options.tree.rollout_spread);
  given.read("exponent", options.walk.exponent);
  given.read("warmth", options.refinement.warmth);
  given.read("coldness", options.refinement.coldness);
  given.read("cycle", options.refinement.cycle);
  given.read("neighbours", options.refinement.neighbours);
  given.read("moves", options.moves);
  given.read("far_legs", options.refinement.far_legs);
  given.read("tree_every", options.tree_every);
  given.read("seeds", options.seeds);
  given.read("warm_start", options.warm_start);
  return std::make_unique<TandemPlanner>(options);
}

const std::map<std::string, MakePlanner>& makers() {
  static const std::map<std::string, MakePlanner> all = [] {
    auto makers = peers();
    makers.emplace("tandem", make_tandem);
    return makers;
  }();
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
