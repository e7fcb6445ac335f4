#include "services/planner/core/planners/peers.hpp"

#include "services/planner/core/baselines/dec_mcts_planner.hpp"
#include "services/planner/core/baselines/greedy_planner.hpp"
#include "services/planner/core/baselines/lawnmower_planner.hpp"
#include "services/planner/core/baselines/nearest_unseen_planner.hpp"
#include "services/planner/core/baselines/sequential_planner.hpp"
#include "services/planner/core/paper/paper_planner.hpp"

namespace tandem {
namespace {

constexpr double kTunedTravelCost_per_s = 0.002;  ///< see bench/reports/planning_tuning

MakePlanner paper(Reading reading, PaperObjective objective, double travel_cost_per_s = 0.0) {
  return [=](PlannerOptions& given) {
    PaperOptions options;
    options.pruning.travel_cost_per_s = travel_cost_per_s;
    options.update.reading = reading;
    options.objective = objective;
    options.trees.nodes = given.whole_number("nodes", options.trees.nodes);
    options.trees.goal_trees = given.whole_number("goal_trees", options.trees.goal_trees);
    options.trees.goal_nodes = given.whole_number("goal_nodes", options.trees.goal_nodes);
    options.trees.step_m = given.number("step_m", options.trees.step_m);
    options.pruning.eligible = given.whole_number("eligible", options.pruning.eligible);
    options.pruning.travel_cost_per_s = given.number("travel_cost", options.pruning.travel_cost_per_s);
    options.update.reduction = given.number("w", options.update.reduction);
    options.update.discount = given.number("gamma", options.update.discount);
    options.rest_sweeps = given.number("rest_sweeps", options.rest_sweeps);
    options.replans_under_way = given.whole_number("replans_under_way", options.replans_under_way ? 1 : 0) != 0;
    return std::make_unique<PaperPlanner>(options);
  };
}

MakePlanner greedy(double exponent, Mates mates) {
  return [=](PlannerOptions& given) {
    GreedyOptions options;
    options.exponent = given.number("exponent", exponent);
    options.most_options = given.whole_number("options", options.most_options);
    options.mates = mates;
    return std::make_unique<GreedyPlanner>(options);
  };
}

MakePlanner sequential(bool only_fastest) {
  return [=](PlannerOptions& given) {
    SequentialOptions options;
    options.only_fastest = only_fastest;
    options.search.exponent = given.number("exponent", options.search.exponent);
    options.search.spread = given.number("spread", options.search.spread);
    options.search.most_options = given.whole_number("options", options.search.most_options);
    options.tries_at_first = given.whole_number("tries", options.tries_at_first);
    return std::make_unique<SequentialPlanner>(options);
  };
}

std::unique_ptr<Planner> dec_mcts(PlannerOptions& given) {
  DecMctsOptions options;
  options.tree.exploration = given.number("exploration", options.tree.exploration);
  options.tree.discount = given.number("discount", options.tree.discount);
  options.rollout.exponent = given.number("exponent", options.rollout.exponent);
  options.rollout.spread = given.number("spread", options.rollout.spread);
  options.rollout.most_options = given.whole_number("options", options.rollout.most_options);
  options.successors = given.whole_number("successors", options.successors);
  options.growths = given.whole_number("growths", options.growths);
  options.intentions = given.whole_number("intentions", options.intentions);
  options.messages_per_choice = given.whole_number("messages_per_choice", options.messages_per_choice);
  options.samples = given.whole_number("samples", options.samples);
  options.step = given.number("step", options.step);
  options.temperature = given.number("temperature", options.temperature);
  options.cooling = given.number("cooling", options.cooling);
  return std::make_unique<DecMctsPlanner>(options);
}

}  // namespace

std::map<std::string, MakePlanner> peers() {
  return {
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
}

}  // namespace tandem
