#pragma once

#include <cstdint>
#include <vector>

namespace tandem::bench {

/// A small search as its actions alone: agents go from place to place on legs, and see cells on them at first sight.
struct ExactModel {
  struct Seen {
    int cell = 0;
    double after_s = 0.0;  ///< from the beginning of the leg
  };
  struct Leg {
    int to = 0;
    double duration_s = 0.0;
    std::vector<Seen> seen;
  };
  struct Agent {
    int start = 0;
    std::vector<Seen> seen_at_start;
    std::vector<std::vector<Leg>> legs_from;  ///< per place
  };
  std::vector<double> mass;  ///< per cell, at most 64; adds up to 1
  std::vector<Agent> agents;
  double horizon_s = 0.0;
  double tail_s = 0.0;  ///< what is left at the horizon is found so much later
};

struct ExactPlan {
  double expected_time_s = 0.0;
  bool proven = false;                   ///< Nothing better exists; otherwise the limit of nodes was reached.
  std::vector<std::vector<int>> places;  ///< per agent, those it goes to
  std::uint64_t nodes = 0;               ///< states looked at
};

/// The best joint plan by branch and bound: who is free first goes on; a state is left aside if each cell seen as soon
/// as anybody could see it would not beat the best plan, or if another state with the same agents at the same places
/// and the same cells seen was there no later at no higher cost. `at_most_s` is the value of a plan that is known.
[[nodiscard]] ExactPlan exact_search(const ExactModel& model, double at_most_s, std::uint64_t node_limit);

/// A room graph: undirected edges, each passed in one step; a room is seen when it is entered.
struct RoomGraph {
  std::vector<double> mass;  ///< per room, adds up to 1; at most 20 rooms
  std::vector<std::vector<int>> neighbours;
};

/// The room graph as actions of agents that start in `starts`.
[[nodiscard]] ExactModel model_of(const RoomGraph& graph, const std::vector<int>& starts, int steps);

/// The least sum of P(not found) over `steps` steps, by dynamic programming over (rooms of the agents, rooms seen):
/// E[T] cut at the end. One or two agents.
[[nodiscard]] double exact_graph_search(const RoomGraph& graph, const std::vector<int>& starts, int steps);

}  // namespace tandem::bench
