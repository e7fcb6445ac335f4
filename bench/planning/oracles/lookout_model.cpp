#include "bench/planning/oracles/lookout_model.hpp"

#include <cassert>
#include <cmath>

namespace tandem::bench {
namespace {

constexpr double kReach_m = 1.0;

ExactModel::Leg leg_of(ActionSet& actions, int from, int to) {
  const tandem::Leg& leg = actions.leg(from, to);
  ExactModel::Leg model{to, leg.duration_s, {}};
  for (std::size_t i = 0; i < leg.seen.size(); ++i) model.seen.push_back({leg.seen.cells[i], leg.seen.enter_s[i]});
  return model;
}

}  // namespace

ExactModel lookout_model(const SearchProblem& problem) {
  assert(problem.masses.size() == 1 && problem.masses.front().size() <= 64);
  ExactModel model;
  model.mass = problem.masses.front();
  model.horizon_s = problem.horizon_s;
  model.tail_s = problem.tail_s;
  problem.world->forget_added_places();
  for (const SearchMember& member : problem.members) {
    ActionSet& actions = problem.world->actions(member.searcher);
    assert(std::isinf(actions.searcher().detection_rate_per_s) && actions.searcher().sees_all_around());
    const int lookouts = actions.lookouts();
    ExactModel::Agent agent;
    agent.start = lookouts;
    agent.legs_from.resize(static_cast<std::size_t>(lookouts) + 1);
    const auto start = actions.add_place(member.pose.position(), kReach_m);
    for (int from = 0; from <= lookouts; ++from) {
      if (from == lookouts && !start) continue;
      for (int to = 0; to < lookouts; ++to) {
        const int place = from == lookouts ? *start : from;
        if (from == to || !actions.is_connected(place, to)) continue;
        agent.legs_from[static_cast<std::size_t>(from)].push_back(leg_of(actions, place, to));
      }
    }
    model.agents.push_back(std::move(agent));
  }
  return model;
}

}  // namespace tandem::bench
