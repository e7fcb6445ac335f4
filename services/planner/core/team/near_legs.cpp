#include "services/planner/core/team/near_legs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using LegsOfPlaces = std::vector<std::vector<NearLegs::Entry>>;

/// All near legs, by the place they begin at.
LegsOfPlaces legs_of_places(const NearLegs& near, const PreparedProblem& problem) {
  ActionSet& actions = *near.actions;
  LegsOfPlaces legs(static_cast<std::size_t>(actions.lookouts()));
  const auto add = [&](int from, int to) {
    const Leg& leg = actions.leg(from, to);
    const auto places = static_cast<std::size_t>(std::max(from, to)) + 1;
    if (legs.size() < places) legs.resize(places);
    if (leg.possible()) legs[static_cast<std::size_t>(from)].push_back({from, to, &leg});
  };
  const auto add_all_from = [&](int place) {
    for (const int lookout : actions.near_lookouts(place)) add(place, lookout);
  };
  for (int lookout = 0; lookout < actions.lookouts(); ++lookout) add_all_from(lookout);
  for (const std::size_t m : near.members) {
    const PreparedProblem::Member& who = problem.members()[m];
    add_all_from(who.start);
    if (!who.goal) continue;
    add_all_from(*who.goal);
    for (const int lookout : actions.near_lookouts(*who.goal)) add(lookout, *who.goal);
    if (actions.is_near(who.start, *who.goal)) add(who.start, *who.goal);
  }
  return legs;
}

std::vector<double> earliest_s(const NearLegs& near, const PreparedProblem& problem, const LegsOfPlaces& legs) {
  std::vector<double> earliest(legs.size(), kInfinity);
  using Arrival = std::pair<double, int>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> open;
  const auto reach = [&](int place, double time_s) {
    if (time_s >= earliest[static_cast<std::size_t>(place)]) return;
    earliest[static_cast<std::size_t>(place)] = time_s;
    open.emplace(time_s, place);
  };
  for (const std::size_t m : near.members) reach(problem.members()[m].start, problem.members()[m].start_s);
  while (!open.empty()) {
    const auto [time_s, place] = open.top();
    open.pop();
    if (time_s > earliest[static_cast<std::size_t>(place)]) continue;
    for (const auto& entry : legs[static_cast<std::size_t>(place)]) reach(entry.to, time_s + entry.leg->duration_s);
  }
  return earliest;
}

std::size_t count_reached(int place, const LegsOfPlaces& next) {
  std::vector<bool> reached(next.size(), false);
  reached[static_cast<std::size_t>(place)] = true;
  std::size_t count = 1;
  for (std::vector<int> open{place}; !open.empty();) {
    const int at = open.back();
    open.pop_back();
    for (const auto& entry : next[static_cast<std::size_t>(at)]) {
      if (reached[static_cast<std::size_t>(entry.to)]) continue;
      reached[static_cast<std::size_t>(entry.to)] = true;
      ++count;
      open.push_back(entry.to);
    }
  }
  return count;
}

/// Whether the lookouts that are reached lead to each other over near legs, and no way leads to any other lookout.
bool is_complete(const NearLegs& near, const PreparedProblem& problem, const LegsOfPlaces& legs) {
  const auto lookouts = static_cast<std::size_t>(near.actions->lookouts());
  LegsOfPlaces forwards(lookouts);
  LegsOfPlaces backwards(lookouts);
  std::size_t reached = 0;
  int any = -1;
  for (std::size_t place = 0; place < lookouts; ++place) {
    if (std::isinf(near.earliest_s[place])) {
      for (const std::size_t m : near.members) {
        if (near.actions->is_connected(problem.members()[m].start, static_cast<int>(place))) return false;
      }
      continue;
    }
    ++reached;
    any = static_cast<int>(place);
    for (const auto& entry : legs[place]) {
      if (entry.to >= near.actions->lookouts()) continue;
      forwards[place].push_back(entry);
      backwards[static_cast<std::size_t>(entry.to)].push_back({entry.to, entry.from, entry.leg});
    }
  }
  return any < 0 || (count_reached(any, forwards) == reached && count_reached(any, backwards) == reached);
}

}  // namespace

std::vector<NearLegs> near_legs(const PreparedProblem& problem) {
  std::vector<NearLegs> all;
  for (std::size_t m = 0; m < problem.members().size(); ++m) {
    if (problem.members()[m].start < 0) continue;
    ActionSet* actions = problem.members()[m].actions;
    auto near = std::ranges::find(all, actions, &NearLegs::actions);
    if (near == all.end()) {
      near = all.insert(all.end(), NearLegs{});
      near->actions = actions;
      near->searcher = problem.problem().members[m].searcher;
    }
    near->members.push_back(m);
  }
  for (NearLegs& near : all) {
    const LegsOfPlaces legs = legs_of_places(near, problem);
    near.earliest_s = earliest_s(near, problem, legs);
    near.complete = is_complete(near, problem, legs);
    for (std::size_t place = 0; place < legs.size(); ++place) {
      if (near.earliest_s[place] >= problem.problem().horizon_s) continue;
      near.legs.insert(near.legs.end(), legs[place].begin(), legs[place].end());
    }
  }
  return all;
}

}  // namespace tandem
