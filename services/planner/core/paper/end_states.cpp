#include "services/planner/core/paper/end_states.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

/// Appends the combinations whose ranks add up to `ranks`, agents from `agent` on.
void add_combinations(const std::vector<std::vector<int>>& goals, std::size_t agent, std::size_t ranks,
                      std::array<int, kMostAgents>& chosen, std::size_t count,
                      std::vector<std::array<int, kMostAgents>>& combinations) {
  if (combinations.size() >= count) return;
  if (agent == goals.size()) {
    if (ranks == 0) combinations.push_back(chosen);
    return;
  }
  for (std::size_t rank = 0; rank < goals[agent].size() && rank <= ranks; ++rank) {
    chosen[agent] = goals[agent][rank];
    add_combinations(goals, agent + 1, ranks - rank, chosen, count, combinations);
  }
}

}  // namespace

std::vector<int> rewarding_goals(const ActionTree& tree, std::size_t count, double apart_m) {
  std::vector<std::pair<double, int>> ends;
  std::vector<std::pair<int, double>> open{{0, tree[0].gain}};
  while (!open.empty()) {
    const auto [at, reward] = open.back();
    open.pop_back();
    const Action& action = tree[static_cast<std::size_t>(at)];
    if (action.eligible.empty()) ends.emplace_back(reward, at);
    for (const int next : action.eligible) open.emplace_back(next, reward + tree[static_cast<std::size_t>(next)].gain);
  }
  std::ranges::sort(
      ends, [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
  const auto place = [&](int action) { return tree[static_cast<std::size_t>(action)].path.points.back().point_in_map; };
  std::vector<int> goals;
  for (const auto& [reward, end] : ends) {
    if (goals.size() >= count) break;
    const auto is_near = [&, end = end](int goal) { return (place(goal) - place(end)).norm() < apart_m; };
    if (std::ranges::none_of(goals, is_near)) goals.push_back(end);
  }
  return goals;
}

std::vector<std::array<int, kMostAgents>> end_state_candidates(const std::vector<std::vector<int>>& goals_of_agents,
                                                               std::size_t count) {
  std::size_t most = 0;
  for (const auto& goals : goals_of_agents) most += goals.size() - 1;
  std::vector<std::array<int, kMostAgents>> combinations;
  std::array<int, kMostAgents> chosen{};
  for (std::size_t ranks = 0; ranks <= most; ++ranks) {
    add_combinations(goals_of_agents, 0, ranks, chosen, count, combinations);
  }
  return combinations;
}

}  // namespace tandem
