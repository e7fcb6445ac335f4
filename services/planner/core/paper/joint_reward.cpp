#include "services/planner/core/paper/joint_reward.hpp"

#include <numeric>
#include <utility>

namespace tandem {

DetectedMass::DetectedMass(std::vector<double> mass, std::vector<ActionTree*> trees, double travel_cost_per_s)
    : mass_(std::move(mass)),
      mass_left_(std::accumulate(mass_.begin(), mass_.end(), 0.0)),
      trees_(std::move(trees)),
      travel_cost_per_s_(travel_cost_per_s),
      kept_(mass_.size(), 1.0) {
  for (const ActionTree* tree : trees_) draws_.emplace_back(tree->size());
}

const std::vector<Draw>& DetectedMass::draws_to(std::size_t agent, int last_action) {
  std::vector<Draw>& draws = draws_[agent][static_cast<std::size_t>(last_action)];
  if (!draws.empty()) return draws;
  const ActionTree& tree = *trees_[agent];
  touched_.clear();
  for (int at = last_action; at >= 0; at = tree[static_cast<std::size_t>(at)].parent) {
    for (const Draw& draw : tree[static_cast<std::size_t>(at)].draws) {
      const auto cell = static_cast<std::size_t>(draw.cell);
      if (mass_[cell] == 0.0) continue;
      if (kept_[cell] == 1.0) touched_.push_back(draw.cell);
      kept_[cell] *= draw.kept;
    }
  }
  for (const std::int32_t cell : touched_) {
    if (const double kept = std::exchange(kept_[static_cast<std::size_t>(cell)], 1.0); kept < 1.0) {
      draws.push_back({cell, kept});
    }
  }
  return draws;
}

double DetectedMass::of(const std::array<int, kMostAgents>& last_actions) {
  std::array<const std::vector<Draw>*, kMostAgents> draws{};
  for (std::size_t agent = 0; agent < trees_.size(); ++agent) draws[agent] = &draws_to(agent, last_actions[agent]);
  double detected = 0.0;
  double travelled_s = 0.0;
  for (std::size_t agent = 0; agent < trees_.size(); ++agent) {
    const Action& last = (*trees_[agent])[static_cast<std::size_t>(last_actions[agent])];
    travelled_s += last.start_s + last.path.duration_s();
    for (const Draw& draw : *draws[agent]) {
      double& kept = kept_[static_cast<std::size_t>(draw.cell)];
      detected += mass_[static_cast<std::size_t>(draw.cell)] * kept * (1.0 - draw.kept);
      kept *= draw.kept;
    }
  }
  for (std::size_t agent = 0; agent < trees_.size(); ++agent) {
    for (const Draw& draw : *draws[agent]) kept_[static_cast<std::size_t>(draw.cell)] = 1.0;
  }
  return (mass_left_ > 0.0 ? detected / mass_left_ : 0.0) - travel_cost_per_s_ * travelled_s;
}

NegativeExpectedTime::NegativeExpectedTime(SearchObjective objective, std::vector<ActionTree*> trees,
                                           std::vector<double> starts_s, std::vector<double> rates_per_s,
                                           std::vector<Look> fixed, double rest_sweeps, double unsearched)
    : objective_(std::move(objective)),
      trees_(std::move(trees)),
      starts_s_(std::move(starts_s)),
      rates_per_s_(std::move(rates_per_s)),
      looks_(std::move(fixed)),
      fixed_(looks_.size()),
      rest_sweeps_(rest_sweeps),
      unsearched_(unsearched) {}

double NegativeExpectedTime::of(const std::array<int, kMostAgents>& last_actions) {
  looks_.resize(fixed_);
  double ends_s = 0.0;
  for (std::size_t agent = 0; agent < trees_.size(); ++agent) {
    const ActionTree& tree = *trees_[agent];
    const Action& last = tree[static_cast<std::size_t>(last_actions[agent])];
    ends_s += (starts_s_[agent] + last.start_s + last.path.duration_s()) / static_cast<double>(trees_.size());
    for (int at = last_actions[agent]; at > 0; at = tree[static_cast<std::size_t>(at)].parent) {
      const Action& action = tree[static_cast<std::size_t>(at)];
      looks_.push_back({&action.seen, starts_s_[agent] + action.start_s, rates_per_s_[agent]});
    }
  }
  const Forecast forecast = objective_.forecast(looks_);
  const double left = 1.0 - forecast.probability_found;
  const double on_the_branch_s = forecast.expected_time_s - left * (objective_.horizon_s() + objective_.tail_s());
  const double sweep_of_the_rest_s = objective_.tail_s() * unsearched_ * left;
  return -(on_the_branch_s + left * (ends_s + rest_sweeps_ * sweep_of_the_rest_s));
}

double share_with_mass(const std::vector<double>& mass, const SearchArea& area) {
  const double sum = std::accumulate(mass.begin(), mass.end(), 0.0);
  double uneven = 0.0;
  for (int cell = 0; cell < area.size(); ++cell) {
    const double share = sum > 0.0 ? mass[static_cast<std::size_t>(cell)] / sum : 0.0;
    if (share > 0.0) uneven += share * share * area.area_m2() / area.floor_m2(cell);
  }
  return uneven > 0.0 ? 1.0 / uneven : 0.0;
}

}  // namespace tandem
