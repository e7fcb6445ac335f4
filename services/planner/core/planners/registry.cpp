#include "services/planner/core/planners/registry.hpp"

#include <map>

#include "services/common/config.hpp"
#include "services/planner/core/planners/peers.hpp"
#include "services/planner/core/team/tandem_planner.hpp"

namespace tandem {
namespace {

std::unique_ptr<Planner> make_tandem(PlannerOptions& given) {
  TandemOptions options;
  options.tree.eligible = given.whole_number("eligible", options.tree.eligible);
  options.tree.exploration = given.number("exploration", options.tree.exploration);
  options.tree.rollout_spread = given.number("rollout_spread", options.tree.rollout_spread);
  options.walk.exponent = given.number("exponent", options.walk.exponent);
  options.refinement.warmth = given.number("warmth", options.refinement.warmth);
  options.refinement.coldness = given.number("coldness", options.refinement.coldness);
  options.refinement.cycle = given.whole_number("cycle", options.refinement.cycle);
  options.refinement.neighbours = given.whole_number("neighbours", options.refinement.neighbours);
  options.moves = given.whole_number("moves", options.moves);
  options.refinement.far_legs = given.number("far_legs", options.refinement.far_legs);
  options.tree_every = given.whole_number("tree_every", options.tree_every);
  options.seeds = given.whole_number("seeds", options.seeds ? 1 : 0) != 0;
  options.warm_start = given.whole_number("warm_start", options.warm_start ? 1 : 0) != 0;
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
