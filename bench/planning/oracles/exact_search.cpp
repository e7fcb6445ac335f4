#include "bench/planning/oracles/exact_search.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <utility>

namespace tandem::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTolerance_s = 1e-9;

/// The time in which one of an agent can at the earliest see a cell from a place: alone and for this cell only.
using EarliestSight = std::vector<std::vector<double>>;  // per place and cell

EarliestSight earliest_sights(const ExactModel::Agent& agent, std::size_t cells) {
  EarliestSight earliest(agent.legs_from.size(), std::vector<double>(cells, kNever));
  for (bool changed = true; changed;) {  // Bellman and Ford: small worlds
    changed = false;
    for (std::size_t from = 0; from < agent.legs_from.size(); ++from) {
      for (const ExactModel::Leg& leg : agent.legs_from[from]) {
        const auto improve = [&](std::size_t cell, double time_s) {
          if (time_s < earliest[from][cell] - kTolerance_s) {
            earliest[from][cell] = time_s;
            changed = true;
          }
        };
        for (const auto& seen : leg.seen) improve(static_cast<std::size_t>(seen.cell), seen.after_s);
        for (std::size_t cell = 0; cell < cells; ++cell) {
          improve(cell, leg.duration_s + earliest[static_cast<std::size_t>(leg.to)][cell]);
        }
      }
    }
  }
  return earliest;
}

class BranchAndBound {
 public:
  BranchAndBound(const ExactModel& model, double at_most_s, std::uint64_t node_limit)
      : model_(model), node_limit_(node_limit), latest_s_(model.horizon_s + model.tail_s) {
    assert(model.mass.size() <= 64);
    best_.expected_time_s = at_most_s;
    first_s_.assign(model.mass.size(), kNever);
    for (const auto& agent : model.agents) {
      earliest_.push_back(earliest_sights(agent, model.mass.size()));
      state_.push_back({agent.start, 0.0});
      places_.emplace_back();
      for (const auto& seen : agent.seen_at_start) first_s_[static_cast<std::size_t>(seen.cell)] = 0.0;
    }
  }

  ExactPlan solve() {
    proven_ = true;
    extend();
    best_.proven = proven_;
    return best_;
  }

 private:
  struct AgentState {
    int place = 0;
    double free_s = 0.0;  ///< infinite: it stays where it is
  };
  struct Known {
    std::vector<double> free_s;
    double cost_s = 0.0;
  };

  [[nodiscard]] double time_of(double first_s) const { return first_s >= model_.horizon_s ? latest_s_ : first_s; }

  /// The cost if nothing more is done.
  [[nodiscard]] double cost_s() const {
    double sum = 0.0;
    for (std::size_t c = 0; c < first_s_.size(); ++c) sum += model_.mass[c] * time_of(first_s_[c]);
    return sum;
  }

  /// No plan that goes on from here costs less: each cell as soon as anybody can see it.
  [[nodiscard]] double bound_s() const {
    double sum = 0.0;
    for (std::size_t c = 0; c < first_s_.size(); ++c) {
      double first_s = first_s_[c];
      for (std::size_t a = 0; a < state_.size(); ++a) {
        first_s = std::min(first_s, state_[a].free_s + earliest_[a][static_cast<std::size_t>(state_[a].place)][c]);
      }
      sum += model_.mass[c] * time_of(first_s);
    }
    return sum;
  }

  /// Whether a state like this one was seen before that was nowhere worse; else this one is kept.
  bool is_dominated(double now_s) {
    std::uint64_t seen = 0;
    double cost_s = 0.0;
    double least_cost_s = 0.0;  // what is seen after now might still be seen earlier
    for (std::size_t c = 0; c < first_s_.size(); ++c) {
      if (first_s_[c] == kNever) continue;
      seen |= std::uint64_t{1} << c;
      cost_s += model_.mass[c] * time_of(first_s_[c]);
      least_cost_s += model_.mass[c] * time_of(std::min(first_s_[c], std::max(now_s, 0.0)));
    }
    std::vector<int> places;
    std::vector<double> free_s;
    for (const AgentState& agent : state_) {
      places.push_back(agent.free_s == kNever ? -1 : agent.place);
      free_s.push_back(agent.free_s);
    }
    std::vector<Known>& known = known_[{std::move(places), seen}];
    for (const Known& other : known) {
      bool earlier = other.cost_s <= least_cost_s + kTolerance_s;
      for (std::size_t a = 0; a < free_s.size(); ++a) earlier = earlier && other.free_s[a] <= free_s[a] + kTolerance_s;
      if (earlier) return true;
    }
    known.push_back({std::move(free_s), cost_s});
    return false;
  }

  void extend() {
    if (++best_.nodes > node_limit_) {
      proven_ = false;
      return;
    }
    const double cost = cost_s();
    if (cost < best_.expected_time_s - kTolerance_s || (best_.places.empty() && cost <= best_.expected_time_s)) {
      best_.expected_time_s = cost;
      best_.places = places_;
    }
    const auto next = std::ranges::min_element(state_, {}, &AgentState::free_s);
    const double now_s = next->free_s;
    if (now_s >= model_.horizon_s || bound_s() >= best_.expected_time_s - kTolerance_s || is_dominated(now_s)) return;
    const auto a = static_cast<std::size_t>(next - state_.begin());
    const AgentState before = state_[a];
    for (const auto* leg : ordered_legs(a)) {
      std::vector<std::pair<int, double>> undo;
      for (const auto& seen : leg->seen) {
        double& first_s = first_s_[static_cast<std::size_t>(seen.cell)];
        if (now_s + seen.after_s >= first_s) continue;
        undo.emplace_back(seen.cell, first_s);
        first_s = now_s + seen.after_s;
      }
      state_[a] = {leg->to, now_s + leg->duration_s};
      places_[a].push_back(leg->to);
      extend();
      places_[a].pop_back();
      for (auto u = undo.rbegin(); u != undo.rend(); ++u) first_s_[static_cast<std::size_t>(u->first)] = u->second;
    }
    state_[a] = {before.place, kNever};  // or it stays
    extend();
    state_[a] = before;
  }

  /// Those that show most new mass per time first.
  [[nodiscard]] std::vector<const ExactModel::Leg*> ordered_legs(std::size_t a) const {
    std::vector<std::pair<double, const ExactModel::Leg*>> legs;
    for (const auto& leg : model_.agents[a].legs_from[static_cast<std::size_t>(state_[a].place)]) {
      double gain = 0.0;
      for (const auto& seen : leg.seen) {
        const auto c = static_cast<std::size_t>(seen.cell);
        gain += first_s_[c] == kNever ? model_.mass[c] : 0.0;
      }
      legs.emplace_back(-gain / (leg.duration_s + kTolerance_s), &leg);
    }
    std::ranges::stable_sort(legs, {}, [](const auto& leg) { return leg.first; });
    std::vector<const ExactModel::Leg*> ordered;
    for (const auto& [score, leg] : legs) ordered.push_back(leg);
    return ordered;
  }

  const ExactModel& model_;
  std::uint64_t node_limit_;
  double latest_s_;
  std::vector<EarliestSight> earliest_;
  std::vector<AgentState> state_;
  std::vector<double> first_s_;  ///< per cell, infinite: not seen
  std::vector<std::vector<int>> places_;
  std::map<std::pair<std::vector<int>, std::uint64_t>, std::vector<Known>> known_;
  ExactPlan best_;
  bool proven_ = true;
};

}  // namespace

ExactPlan exact_search(const ExactModel& model, double at_most_s, std::uint64_t node_limit) {
  return BranchAndBound(model, at_most_s, node_limit).solve();
}

ExactModel model_of(const RoomGraph& graph, const std::vector<int>& starts, int steps) {
  ExactModel model;
  model.mass = graph.mass;
  model.horizon_s = steps;
  for (const int start : starts) {
    ExactModel::Agent agent{start, {{start, 0.0}}, {}};
    for (const auto& neighbours : graph.neighbours) {
      agent.legs_from.emplace_back();
      for (const int to : neighbours) agent.legs_from.back().push_back({to, 1.0, {{to, 1.0}}});
    }
    model.agents.push_back(agent);
  }
  return model;
}

double exact_graph_search(const RoomGraph& graph, const std::vector<int>& starts, int steps) {
  assert(graph.mass.size() <= 20 && !starts.empty() && starts.size() <= 2);
  const std::size_t rooms = graph.mass.size();
  const int first = starts.front();
  const int second = starts.size() > 1 ? starts[1] : -1;  // -1: nobody
  using State = std::pair<std::uint32_t, std::pair<int, int>>;
  std::map<State, double> now;  // the least sum so far
  std::uint32_t seen_at_start = 1U << first;
  if (second >= 0) seen_at_start |= 1U << second;
  now[{seen_at_start, {first, second}}] = 0.0;
  const auto left = [&](std::uint32_t seen) {
    double sum = 0.0;
    for (std::size_t room = 0; room < rooms; ++room) sum += (seen >> room & 1U) != 0 ? 0.0 : graph.mass[room];
    return sum;
  };
  const std::vector<int> nobody{-1};
  for (int step = 0; step < steps; ++step) {
    std::map<State, double> next;
    for (const auto& [state, so_far] : now) {
      const auto& [seen, places] = state;
      const double cost = so_far + left(seen);
      const auto moves = [&](int from) {
        if (from < 0) return nobody;
        std::vector<int> to = graph.neighbours[static_cast<std::size_t>(from)];
        to.push_back(from);
        return to;
      };
      const auto second_moves = moves(places.second);
      for (const int a : moves(places.first)) {
        for (const int b : second_moves) {
          const std::uint32_t then = seen | 1U << a | (b >= 0 ? 1U << b : 0U);
          const auto [entry, is_new] = next.try_emplace({then, {a, b}}, cost);
          if (!is_new) entry->second = std::min(entry->second, cost);
        }
      }
    }
    now = std::move(next);
  }
  double best = kNever;
  for (const auto& [state, sum] : now) best = std::min(best, sum);
  return best;
}

}  // namespace tandem::bench
