#include "services/planner/core/paper/paper_planner.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "services/planner/core/paper/end_states.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kGoals = 8;  ///< of each agent, combined to end states
constexpr std::size_t kEndStates = 64;
constexpr double kGoalsApart_m = 4.0;
constexpr double kNothingNew = 1e-6;  ///< share of the mass left
constexpr int kRolloutsPerStop = 16;
constexpr double kLeastUnsearched = 0.1;  ///< share of the area: even what lies in one place has to be got to

/// The mass of all objects that is not detected by `looks`, which happen whatever is planned.
std::vector<double> mass_without(const std::vector<std::vector<double>>& masses, const std::vector<Look>& looks) {
  std::vector<double> mass(masses.front().size(), 0.0);
  for (const auto& of_object : masses) std::ranges::transform(mass, of_object, mass.begin(), std::plus{});
  for (const Look& look : looks) {
    const Sightings& seen = *look.seen;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      mass[static_cast<std::size_t>(seen.cells[i])] *=
          std::isinf(look.rate_per_s) ? 0.0 : std::exp(-look.rate_per_s * (seen.leave_s[i] - seen.enter_s[i]));
    }
  }
  return mass;
}

/// A way as a tree without branches, in movements of at most `step_m`.
std::vector<TreeNode> chain(const std::vector<Vector2d>& way, double step_m) {
  std::vector<TreeNode> nodes;
  if (way.empty()) return nodes;
  nodes.push_back({way.front(), -1, 0.0});
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length_m = (way[i] - way[i - 1]).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
    for (int piece = 1; piece <= pieces; ++piece) {
      const double cost_m = nodes.back().cost_m + length_m / pieces;
      nodes.push_back(
          {way[i - 1] + (way[i] - way[i - 1]) * piece / pieces, static_cast<int>(nodes.size()) - 1, cost_m});
    }
  }
  return nodes;
}

double mass_in(const View& view, const std::vector<double>& mass) {
  return std::accumulate(view.begin(), view.end(), 0.0,
                         [&](double sum, int cell) { return sum + mass[static_cast<std::size_t>(cell)]; });
}

/// The way to the nearest lookout from which something unseen can be seen; empty if there is none.
std::vector<Vector2d> way_to_nearest_unseen(ActionSet& actions, int from, const std::vector<double>& mass) {
  int nearest = -1;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int lookout = 0; lookout < actions.lookouts(); ++lookout) {
    const double distance_m = actions.distance_m(from, lookout);
    if (distance_m >= nearest_m || mass_in(actions.panorama(lookout), mass) <= 0.0) continue;
    if (!actions.leg(from, lookout).possible()) continue;
    nearest = lookout;
    nearest_m = distance_m;
  }
  return nearest < 0 ? std::vector<Vector2d>{} : actions.leg(from, nearest).way;
}

}  // namespace

void PaperPlanner::begin(const SearchProblem& problem, Rng rng) {
  rng_ = rng;
  rollouts_ = 0;
  has_best_ = false;
  met_.clear();
  problem_ = std::make_unique<PreparedProblem>(problem);
  mass_ = mass_without(problem.masses, problem_->fixed_looks());

  trees_.clear();
  std::vector<std::int64_t> ready_ms;
  std::vector<double> starts_s;
  std::vector<double> rates_per_s;
  for (std::size_t m = 0; m < problem_->members().size(); ++m) {
    const PreparedProblem::Member& who = problem_->members()[m];
    trees_.push_back(grown_actions(m));
    starts_s.push_back(who.start_s);
    ready_ms.push_back(std::llround(1e3 * who.start_s));
    rates_per_s.push_back(who.actions->searcher().detection_rate_per_s);
  }
  tree_pointers_.clear();
  for (ActionTree& tree : trees_) tree_pointers_.push_back(&tree);
  root_ = root_state(ready_ms);
  if (options_.objective == PaperObjective::DetectedMass) {
    objective_ = std::make_unique<std::variant<DetectedMass, NegativeExpectedTime>>(
        std::in_place_type<DetectedMass>, mass_, tree_pointers_, options_.pruning.travel_cost_per_s);
  } else {
    double unsearched = 0.0;
    for (const auto& of_object : problem.masses) {
      unsearched += share_with_mass(of_object, problem.world->area()) / static_cast<double>(problem.masses.size());
    }
    objective_ = std::make_unique<std::variant<DetectedMass, NegativeExpectedTime>>(
        std::in_place_type<NegativeExpectedTime>, SearchObjective(problem.masses, problem.horizon_s, problem.tail_s),
        tree_pointers_, starts_s, rates_per_s, problem_->fixed_looks(), options_.rest_sweeps,
        std::max(kLeastUnsearched, unsearched));
  }
  expand_end_states();
}

std::vector<Vector2d> PaperPlanner::richest_places(ActionSet& actions) const {
  std::vector<double> left = mass_;
  std::vector<Vector2d> places;
  for (int k = 0; k < options_.trees.goal_trees; ++k) {
    int richest = -1;
    double most = 0.0;
    for (int lookout = 0; lookout < actions.lookouts(); ++lookout) {
      const double mass = mass_in(actions.panorama(lookout), left);
      if (mass <= most) continue;
      most = mass;
      richest = lookout;
    }
    if (richest < 0) break;
    places.push_back(actions.place(richest));
    for (const int cell : actions.panorama(richest)) left[static_cast<std::size_t>(cell)] = 0.0;
  }
  return places;
}

ActionTree PaperPlanner::pruned(std::vector<TreeNode> nodes, std::size_t member) {
  const PreparedProblem::Member& who = problem_->members()[member];
  ViewTable& views = problem_->problem().world->views(problem_->problem().members[member].searcher);
  ActionTree tree = action_tree(nodes, who.heading_rad, who.end_s - who.start_s, views);
  prune(tree, mass_, options_.pruning);
  return tree;
}

ActionTree PaperPlanner::grown_actions(std::size_t member) {
  const PreparedProblem::Member& who = problem_->members()[member];
  const SearchMember& asked = problem_->problem().members[member];
  if (who.start < 0) {
    const Vector2d stays =
        asked.committed.points.empty() ? asked.pose.position() : asked.committed.points.back().point_in_map;
    return pruned({{stays, -1, 0.0}}, member);
  }
  ActionSet& actions = *who.actions;
  const Vector2d start = actions.place(who.start);
  const double radius_m = actions.searcher().radius_m;
  if (who.goal) {
    auto nodes = multi_rrt_to(actions.motion(), radius_m, start, actions.place(*who.goal), options_.trees, rng_);
    if (nodes.size() == 1) nodes = chain(actions.leg(who.start, *who.goal).way, options_.trees.step_m);
    if (nodes.empty()) nodes.push_back({start, -1, 0.0});
    return pruned(std::move(nodes), member);
  }
  ActionTree tree =
      pruned(multi_rrt(actions.motion(), radius_m, start, richest_places(actions), options_.trees, rng_), member);
  const double mass_left = std::accumulate(mass_.begin(), mass_.end(), 0.0);
  const bool sees_new =
      std::ranges::any_of(tree, [&](const Action& action) { return action.gain > kNothingNew * mass_left; });
  if (sees_new) return tree;
  const auto way = way_to_nearest_unseen(actions, who.start, mass_);
  return way.empty() ? tree : pruned(chain(way, options_.trees.step_m), member);
}

void PaperPlanner::expand_end_states() {
  std::vector<std::vector<int>> goals;
  for (const ActionTree& tree : trees_) goals.push_back(rewarding_goals(tree, kGoals, kGoalsApart_m));
  for (const LastActions& candidate : end_state_candidates(goals, kEndStates)) take(candidate);
}

void PaperPlanner::take(const LastActions& last_actions) {
  if (!met_.insert(last_actions).second) return;
  const double reward = std::visit([&](auto& objective) { return objective.of(last_actions); }, *objective_);
  if (has_best_ && !best_is_rejected_ && reward <= best_reward_) return;
  const auto& rejected_plans = problem_->problem().rejected;
  const bool is_rejected = !rejected_plans.empty() &&
                           std::ranges::any_of(rejected_plans, [&, walked = paths(last_actions)](const auto& rejected) {
                             return is_like(walked, rejected);
                           });
  if (has_best_ && (is_rejected > best_is_rejected_ || (is_rejected == best_is_rejected_ && reward <= best_reward_))) {
    return;
  }
  best_ = last_actions;
  best_reward_ = reward;
  best_is_rejected_ = is_rejected;
  has_best_ = true;
}

void PaperPlanner::run(int rollouts, const std::function<bool()>& stop) {
  const auto horizon_ms = std::llround(1e3 * problem_->problem().horizon_s);
  for (int i = 0; i < rollouts; ++i) {
    if (stop && i % kRolloutsPerStop == 0 && stop()) return;
    const JointState last = rollout(root_, tree_pointers_, horizon_ms, rng_);
    take(last.ongoing);
    for (std::size_t agent = 0; agent < trees_.size(); ++agent) {
      reduce_selection(trees_[agent], last.ongoing[agent], options_.update);
    }
    ++rollouts_;
  }
}

std::vector<TimedPath> PaperPlanner::paths(const LastActions& last_actions) const {
  std::vector<TimedPath> paths;
  for (std::size_t m = 0; m < trees_.size(); ++m) {
    TimedPath path = problem_->problem().members[m].committed;
    for (const TimedPoint& point : path_to(trees_[m], last_actions[m]).points) {
      const double time_s = problem_->members()[m].start_s + point.time_s;
      if (path.points.empty() || time_s > path.duration_s()) path.points.push_back({time_s, point.point_in_map});
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

JointPlan PaperPlanner::best() {
  return evaluated(problem_->problem(), paths(best_));
}

}  // namespace tandem
