#include "services/planner/core/planners/peers.hpp"

#include <utility>

#include "services/planner/core/baselines/dec_mcts_planner.hpp"
#include "services/planner/core/baselines/greedy_planner.hpp"
#include "services/planner/core/baselines/lawnmower_planner.hpp"
#include "services/planner/core/baselines/nearest_unseen_planner.hpp"
#include "services/planner/core/baselines/sequential_planner.hpp"
#include "services/planner/core/paper/paper_planner.hpp"
#include "services/planner/core/planners/heeding_rejections.hpp"

namespace tandem {
namespace {

constexpr double kTunedTravelCost_per_s = 0.002;  ///< see bench/reports/planning_tuning

void read_search(RouteSearchOptions& search, PlannerOptions& given) {
  given.read("exponent", search.exponent);
  given.read("spread", search.spread);
  given.read("options", search.most_options);
}

MakePlanner paper(Reading reading, PaperObjective objective, double travel_cost_per_s = 0.0) {
  return [=](PlannerOptions& given) {
    PaperOptions options;
    options.pruning.travel_cost_per_s = travel_cost_per_s;
    options.update.reading = reading;
    options.objective = objective;
    given.read("nodes", options.trees.nodes);
    given.read("goal_trees", options.trees.goal_trees);
    given.read("goal_nodes", options.trees.goal_nodes);
    given.read("step_m", options.trees.step_m);
    given.read("eligible", options.pruning.eligible);
    given.read("travel_cost", options.pruning.travel_cost_per_s);
    given.read("w", options.update.reduction);
    given.read("gamma", options.update.discount);
    given.read("rest_sweeps", options.rest_sweeps);
    given.read("replans_under_way", options.replans_under_way);
    return std::make_unique<PaperPlanner>(options);
  };
}

MakePlanner greedy(double exponent, Mates mates) {
  return [=](PlannerOptions& given) {
    GreedyOptions options;
    options.exponent = exponent;
    given.read("exponent", options.exponent);
    given.read("options", options.most_options);
    options.mates = mates;
    return std::make_unique<GreedyPlanner>(options);
  };
}

MakePlanner sequential(bool only_fastest) {
  return [=](PlannerOptions& given) {
    SequentialOptions options;
    options.only_fastest = only_fastest;
    read_search(options.search, given);
    given.read("tries", options.tries_at_first);
    return std::make_unique<SequentialPlanner>(options);
  };
}

std::unique_ptr<Planner> dec_mcts(PlannerOptions& given) {
  DecMctsOptions options;
  given.read("exploration", options.tree.exploration);
  given.read("discount", options.tree.discount);
  read_search(options.rollout, given);
  given.read("successors", options.successors);
  given.read("growths", options.growths);
  given.read("intentions", options.intentions);
  given.read("messages_per_choice", options.messages_per_choice);
  given.read("samples", options.samples);
  given.read("step", options.step);
  given.read("temperature", options.temperature);
  given.read("cooling", options.cooling);
  return std::make_unique<DecMctsPlanner>(options);
}

}  // namespace

std::map<std::string, MakePlanner> peers() {
  std::map<std::string, MakePlanner> makers{
      {"paper", paper(Reading::Sound, PaperObjective::DetectedMass)},
      {"paper_printed", paper(Reading::Printed, PaperObjective::DetectedMass)},
      {"paper_travel", paper(Reading::Sound, PaperObjective::DetectedMass, kTunedTravelCost_per_s)},
      {"paper_corrected", paper(Reading::Sound, PaperObjective::ExpectedTime)},
      {"greedy", greedy(1.0, Mates::Coordinated)},
      {"greedy15", greedy(1.5, Mates::Coordinated)},
      {"no_intent", greedy(1.5, Mates::NoIntent)},
      {"independent", greedy(1.5, Mates::Independent)},
      {"nearest_unseen", [](PlannerOptions&) { return std::make_unique<NearestUnseenPlanner>(); }},
      {"lawnmower", [](PlannerOptions&) { return std::make_unique<LawnmowerPlanner>(); }},
      {"sequential", sequential(false)},
      {"single", sequential(true)},
      {"dec_mcts", dec_mcts},
  };
  for (auto& [name, make] : makers) {
    make = [make = std::move(make)](PlannerOptions& given) { return std::make_unique<HeedingRejections>(make(given)); };
  }
  return makers;
}

}  // namespace tandem
