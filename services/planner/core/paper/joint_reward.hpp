#pragma once

#include <vector>

#include "services/planner/core/paper/joint_rollout.hpp"
#include "services/planner/core/search/search_area.hpp"
#include "services/planner/core/search/search_objective.hpp"

namespace tandem {

/// The objective g as printed, (15) with (28): the mass that the team detects, in parts of what was left, whenever it
/// does so, and what the ways cost. A source pays once, whoever draws on it: pools are joint.
class DetectedMass {
 public:
  /// `mass` is what each search cell can still pay; the trees outlive it.
  DetectedMass(std::vector<double> mass, std::vector<ActionTree*> trees, double travel_cost_per_s);

  /// Of the sequences to these actions, one an agent. Higher is better.
  [[nodiscard]] double of(const std::array<int, kMostAgents>& last_actions);

 private:
  /// What a whole sequence leaves in each cell it draws on, each cell once.
  const std::vector<Draw>& draws_to(std::size_t agent, int last_action);

  std::vector<double> mass_;
  double mass_left_ = 0.0;
  std::vector<ActionTree*> trees_;
  double travel_cost_per_s_;
  std::vector<std::vector<std::vector<Draw>>> draws_;  ///< per agent and action, empty until asked for
  std::vector<double> kept_;                           ///< scratch, all 1 between calls
  std::vector<std::int32_t> touched_;
};

/// The objective of the corrected planner (digest A1, A2): minus the expected time to find [s].
///
/// A branch ends long before the search does. What it leaves is taken to be found from then on, on average after
/// `rest_sweeps` sweeps of what is left then, so that branches of all lengths are compared over the same search. Half a
/// sweep would be needed if nothing were seen twice; in scattered leftovers it is more.
class NegativeExpectedTime {
 public:
  /// `starts_s`: when each agent's first action begins. `unsearched`: the share of the area that is to be searched yet.
  /// The trees and what `fixed` points at outlive it.
  NegativeExpectedTime(SearchObjective objective, std::vector<ActionTree*> trees, std::vector<double> starts_s,
                       std::vector<double> rates_per_s, std::vector<Look> fixed, double rest_sweeps, double unsearched);

  /// Of the sequences to these actions, one an agent. Higher is better.
  [[nodiscard]] double of(const std::array<int, kMostAgents>& last_actions);

 private:
  SearchObjective objective_;
  std::vector<ActionTree*> trees_;
  std::vector<double> starts_s_;
  std::vector<double> rates_per_s_;
  std::vector<Look> looks_;
  std::size_t fixed_;
  double rest_sweeps_;
  double unsearched_;
};

/// The share of an area that holds `mass`, if where there is any it is spread evenly: 1 / sum of p^2 A / a over cells
/// of size a in an area A, with p the share of the mass. It does not depend on how much mass that is.
[[nodiscard]] double share_with_mass(const std::vector<double>& mass, const SearchArea& area);

}  // namespace tandem
