#include "bench/planning/report/campaign.hpp"

#include <algorithm>

namespace tandem::bench {
namespace {

/// What a part of a report needs: closed loops.
struct Loops {
  std::vector<int> rows;  ///< of the report that use them
  std::vector<std::string> families;
  std::vector<std::string> planners;
  int quick_instances = 0;
  int full_instances = 0;
  std::string full_budgets;
};

/// First plans, with what they are compared to.
struct Plans {
  std::vector<int> rows;
  std::vector<std::string> families;
  std::vector<std::string> planners;
  int quick_instances = 0;
  int full_instances = 0;
  std::vector<double> quick_budgets_ms;
  std::vector<double> full_budgets_ms;
  bool exact = false;
};

struct Figures {
  std::vector<int> rows;
  std::vector<std::string> measures;
  std::vector<std::string> families;
  int quick_instances = 0;
  int full_instances = 0;
};

const std::vector<std::string> kPeers{kOurs, kPaper, kPaperCorrected, kTunedGreedy, "greedy", "lawnmower"};
const std::vector<std::string> kAllPeers{"no_intent",  "nearest_unseen", "independent",
                                         "sequential", "dec_mcts",       "single"};

const std::vector<Loops>& loops() {
  static const std::vector<Loops> parts{
      {{1, 2, 3, 10}, {"S1u", "S1x"}, kPeers, 5, 30, "200"},
      {{1, 2, 3, 10}, {"S1u", "S1x"}, {kOurs, kPaper, kTunedGreedy}, 0, 15, "50"},
      {{1}, {"S1u", "S1x"}, {"paper_travel"}, 2, 15, "200"},
      {{1, 2, 3, 10}, {"S1u4"}, kPeers, 3, 20, "200"},
      {{1, 2, 3}, {"S1uR4"}, kPeers, 0, 20, "200"},
      {{3}, {"S1u"}, kAllPeers, 2, 10, "200"},
      {{3}, {"S8g", "S8f", "S8d"}, {kOurs, kPaper, kTunedGreedy, "dec_mcts"}, 2, 10, "200"},
      {{3}, {"S4", "S6", "S1brl", "S1l1", "S1l3"}, {kOurs, kPaper, kTunedGreedy}, 0, 5, "200"},
      {{3}, {"S2r2", "S2p2"}, {kOurs, kTunedGreedy}, 0, 2, "200"},
      {{10},
       {"S5obedient", "S5late", "S5own", "S5random", "S5stubborn", "S5announces"},
       {kOurs, "tandem@clairvoyant", "tandem@alone"},
       0,
       10,
       "50"}};
  return parts;
}

const std::vector<Plans>& plans() {
  static const std::vector<double> anytime_ms{10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
  static const std::vector<double> pool_ms{10.0, 50.0, 200.0, 1000.0, 5000.0, 60000.0};
  static const std::vector<Plans> parts{
      {{4}, {"S0m1", "S0m", "S0m3"}, {kOurs, kTunedGreedy, "sequential", "dec_mcts"}, 10, 33, {100.0}, {100.0}, true},
      {{5, 6, 7}, {"S1u", "S1x", "S1u4", "S1uR4"}, {kOurs}, 3, 6, anytime_ms, pool_ms, false},
      {{6, 7}, {"S1u"}, {kPaper, kTunedGreedy, "dec_mcts", "sequential"}, 2, 10, anytime_ms, anytime_ms, false},
      {{6, 7, 9}, {"S2r2", "S2p2"}, {kOurs}, 1, 3, anytime_ms, pool_ms, false},
      {{7, 9}, {"S2r4", "S2r8"}, {kOurs}, 0, 3, {}, anytime_ms, false},
      {{7, 9}, {"S3c2", "S3c4", "S3c8"}, {kOurs}, 0, 2, {}, anytime_ms, false}};
  return parts;
}

const std::vector<Figures>& figures() {
  static const std::vector<Figures> parts{
      {{8}, {"evaluations", "changes", "objective", "rollouts"}, {"S1u", "S1uR4"}, 2, 5},
      {{9}, {"memory"}, {"S1u", "S2r2"}, 1, 1},
      {{9}, {"memory"}, {"S3c2"}, 0, 1},
      {{11}, {"reproducible", "searches"}, {"S1u"}, 1, 3}};
  return parts;
}

bool wanted(const CampaignOptions& options, const std::vector<int>& rows) {
  return options.rows.empty() ||
         std::ranges::any_of(rows, [&](int row) { return std::ranges::find(options.rows, row) != options.rows.end(); });
}

std::vector<std::uint64_t> seeds(std::uint64_t first, int count) {
  std::vector<std::uint64_t> list;
  for (int i = 0; i < count; ++i) list.push_back(first + static_cast<std::uint64_t>(i));
  return list;
}

}  // namespace

Campaign campaign_of(const CampaignOptions& options) {
  Campaign campaign;
  const auto count = [&](const auto& part) { return options.quick ? part.quick_instances : part.full_instances; };
  const auto add_loops = [&](const std::vector<std::string>& families, const std::vector<std::string>& planners,
                             int instances, const std::string& budgets) {
    const auto runs = all_runs(families, seeds(options.first_seed, instances), planners, parse_budgets(budgets));
    campaign.runs.insert(campaign.runs.end(), runs.begin(), runs.end());
  };
  for (const Loops& part : loops()) {
    if (!wanted(options, part.rows)) continue;
    add_loops(part.families, part.planners, count(part), options.quick ? "50" : part.full_budgets);
  }
  std::vector<std::string> without;
  for (const std::string& option : options.ablations) without.push_back(std::string(kOurs) + ":" + option);
  if (wanted(options, {1})) add_loops({"S1u", "S1x"}, without, options.quick ? 1 : 10, options.quick ? "50" : "200");
  for (const Plans& part : plans()) {
    if (!wanted(options, part.rows)) continue;
    for (const auto& family : part.families) {
      for (const std::uint64_t seed : seeds(options.first_seed, count(part))) {
        for (const auto& planner : part.planners) {
          campaign.first_plans.push_back({{family, seed, planner, 1},
                                          options.quick ? part.quick_budgets_ms : part.full_budgets_ms,
                                          part.exact && planner == kOurs});
        }
      }
    }
  }
  for (const Figures& part : figures()) {
    if (!wanted(options, part.rows)) continue;
    for (const auto& measure : part.measures) {
      for (const auto& family : part.families) {
        for (const std::uint64_t seed : seeds(options.first_seed, count(part))) {
          campaign.micro.push_back({{measure, family, seed}});
        }
      }
    }
  }
  if (wanted(options, {12})) {
    for (const std::uint64_t seed : seeds(options.first_seed, options.quick ? 20 : 50)) {
      campaign.tasks.push_back({{seed, 8, 200.0}});
    }
  }
  return campaign;
}

}  // namespace tandem::bench
