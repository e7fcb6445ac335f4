#pragma once

#include <cstdint>
#include <vector>

#include "services/planner/core/paper/rrt_star.hpp"
#include "services/planner/core/search/sightings.hpp"

namespace tandem {

/// What a movement leaves of the pool of the source in a search cell: the cell pays 1 - `kept` of what is in it.
struct Draw {
  std::int32_t cell = -1;
  double kept = 1.0;
};

/// One action of an agent: the movement from its parent's place to its own (paper 4.3.1).
struct Action {
  int parent = -1;                ///< -1: the virtual action of no time at the root
  std::int64_t duration_ms = 0;   ///< whole milliseconds, so that equal times are equal (digest F9)
  double start_s = 0.0;           ///< after the agent's first action begins [s]
  double heading_rad = 0.0;       ///< at its end
  TimedPath path;                 ///< from its own beginning
  Sightings seen;                 ///< from its own beginning
  std::vector<Draw> draws;        ///< each cell once
  double gain = 0.0;              ///< reward of this movement, everything before it taken alone
  double bound = 0.0;             ///< the most that sequences below it can add, taken alone
  std::vector<int> eligible;      ///< of its children those that plans are made of
  std::vector<double> selection;  ///< q of the paper: the probability of each of `eligible`
};

/// The action set of one agent: all sequences from the root. Parents stand before their children.
using ActionTree = std::vector<Action>;

/// The movements along `nodes` of a tree, as `views`' searcher walks and sees them; those that would end after
/// `limit_s` are left out. Node 0 is the root, parents stand before their children.
[[nodiscard]] ActionTree action_tree(const std::vector<TreeNode>& nodes, double initial_heading_rad, double limit_s,
                                     ViewTable& views);

struct PruningOptions {
  int eligible = 4;                ///< N_a of the paper
  double travel_cost_per_s = 0.0;  ///< R_A: what a second on the way costs, in parts of the mass that is left
};

/// Rewards each sequence as if its agent were alone, hands the best attainable one back to every action, keeps the
/// `options.eligible` best children of each, and makes their selection proportional to what they promise (paper 4.3.1,
/// digest E4: shifted to be positive, nothing below kLeastSelection).
///
/// `mass` is what each search cell can still pay.
void prune(ActionTree& tree, const std::vector<double>& mass, const PruningOptions& options);

/// No eligible action is less likely than this.
inline constexpr double kLeastSelection = 1e-3;

/// Makes probabilities of positive weights, none below kLeastSelection.
void normalise(std::vector<double>& selection);

/// The actions that lead from the root to `action`, itself included, the root's own not.
[[nodiscard]] std::vector<int> sequence_to(const ActionTree& tree, int action);

/// The path of a sequence, from the root's place at time 0.
[[nodiscard]] TimedPath path_to(const ActionTree& tree, int action);

}  // namespace tandem
