#include "services/planner/core/paper/multi_rrt.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <set>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr int kTriesPerNode = 4;
constexpr double kDetourFactor = 1.5;
constexpr double kDetour_m = 4.0;
constexpr std::size_t kMostWaysToGoal = 40;

RrtStar grown(const MotionMap& motion, double radius_m, const Vector2d& root, double step_m, int nodes, Rng& rng) {
  RrtStar tree(motion, radius_m, step_m, root);
  if (motion.size() == 0) return tree;
  for (int tries = 0; tries < kTriesPerNode * nodes && static_cast<int>(tree.nodes().size()) < nodes; ++tries) {
    (void)tree.extend(random_place(motion, rng));
  }
  return tree;
}

/// A place where a goal's tree meets the agent's.
struct Meeting {
  int agent_node = -1;
  int goal_node = -1;
  double cost_m = std::numeric_limits<double>::infinity();  ///< from the agent to the root of the goal's tree
};

/// All of them, the shortest way first.
std::vector<Meeting> meetings(const RrtStar& agent, const RrtStar& goal, double step_m) {
  std::vector<Meeting> meetings;
  for (std::size_t g = 0; g < goal.nodes().size(); ++g) {
    const TreeNode& there = goal.nodes()[g];
    for (const int a : agent.joined_within(there.point_in_map, step_m)) {
      const TreeNode& here = agent.nodes()[static_cast<std::size_t>(a)];
      meetings.push_back(
          {a, static_cast<int>(g), here.cost_m + (here.point_in_map - there.point_in_map).norm() + there.cost_m});
    }
  }
  std::ranges::stable_sort(meetings, {}, &Meeting::cost_m);
  return meetings;
}

int added(std::vector<TreeNode>& nodes, const Vector2d& point, int parent) {
  const TreeNode& above = nodes[static_cast<std::size_t>(parent)];
  nodes.push_back({point, parent, above.cost_m + (point - above.point_in_map).norm()});
  return static_cast<int>(nodes.size()) - 1;
}

/// Appends the way from `entry` to the root of a goal's tree below `parent`.
void append_way(std::vector<TreeNode>& nodes, const RrtStar& goal, int entry, int parent) {
  int last = parent;
  for (int at = entry; at >= 0; at = goal.nodes()[static_cast<std::size_t>(at)].parent) {
    last = added(nodes, goal.nodes()[static_cast<std::size_t>(at)].point_in_map, last);
  }
}

/// The same nodes, parents before their children.
std::vector<TreeNode> in_order(const std::vector<TreeNode>& nodes, std::vector<int>& new_index) {
  std::vector<std::vector<int>> children(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent >= 0) children[static_cast<std::size_t>(nodes[i].parent)].push_back(static_cast<int>(i));
  }
  std::vector<TreeNode> ordered;
  new_index.assign(nodes.size(), -1);
  std::deque<int> open{0};
  while (!open.empty()) {
    const auto at = static_cast<std::size_t>(open.front());
    open.pop_front();
    new_index[at] = static_cast<int>(ordered.size());
    ordered.push_back(nodes[at]);
    if (nodes[at].parent >= 0) ordered.back().parent = new_index[static_cast<std::size_t>(nodes[at].parent)];
    open.insert(open.end(), children[at].begin(), children[at].end());
  }
  return ordered;
}

}  // namespace

std::vector<TreeNode> multi_rrt(const MotionMap& motion, double radius_m, const Vector2d& start_in_map,
                                const std::vector<Vector2d>& sources, const MultiRrtOptions& options, Rng& rng) {
  const RrtStar agent = grown(motion, radius_m, start_in_map, options.step_m, options.nodes, rng);
  std::vector<int> index;
  std::vector<TreeNode> nodes = in_order(agent.nodes(), index);
  for (std::size_t k = 0; k < sources.size() && static_cast<int>(k) < options.goal_trees; ++k) {
    const RrtStar goal = grown(motion, radius_m, sources[k], options.step_m, options.goal_nodes, rng);
    const auto met = meetings(agent, goal, options.step_m);
    if (met.empty()) continue;
    append_way(nodes, goal, met.front().goal_node, index[static_cast<std::size_t>(met.front().agent_node)]);
  }
  return nodes;
}

std::vector<TreeNode> multi_rrt_to(const MotionMap& motion, double radius_m, const Vector2d& start_in_map,
                                   const Vector2d& goal_in_map, const MultiRrtOptions& options, Rng& rng) {
  const RrtStar agent = grown(motion, radius_m, start_in_map, options.step_m, options.nodes, rng);
  const RrtStar goal = grown(motion, radius_m, goal_in_map, options.step_m, options.goal_nodes, rng);
  std::vector<int> index(agent.nodes().size(), -1);
  std::vector<TreeNode> nodes{{start_in_map, -1, 0.0}};
  index[0] = 0;
  // Below each node of the agent's tree at most one way to the goal, and through each node of the goal's tree.
  std::set<int> agent_nodes;
  std::set<int> goal_nodes;
  const auto met = meetings(agent, goal, options.step_m);
  for (const Meeting& meeting : met) {
    if (meeting.cost_m > kDetourFactor * met.front().cost_m + kDetour_m) break;
    if (agent_nodes.size() >= kMostWaysToGoal) break;
    if (agent_nodes.contains(meeting.agent_node) || goal_nodes.contains(meeting.goal_node)) continue;
    agent_nodes.insert(meeting.agent_node);
    goal_nodes.insert(meeting.goal_node);
    std::vector<int> above;
    for (int at = meeting.agent_node; index[static_cast<std::size_t>(at)] < 0;
         at = agent.nodes()[static_cast<std::size_t>(at)].parent) {
      above.push_back(at);
    }
    for (auto at = above.rbegin(); at != above.rend(); ++at) {
      const TreeNode& node = agent.nodes()[static_cast<std::size_t>(*at)];
      index[static_cast<std::size_t>(*at)] =
          added(nodes, node.point_in_map, index[static_cast<std::size_t>(node.parent)]);
    }
    append_way(nodes, goal, meeting.goal_node, index[static_cast<std::size_t>(meeting.agent_node)]);
  }
  return nodes;
}

}  // namespace tandem
