#include "services/planner/core/team/team_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tandem {
namespace {

constexpr double kUntried = 0.5;  ///< what an untried action is taken to be worth, between reference (0) and best (1)

}  // namespace

TeamPlanner::TeamPlanner(const TeamProblem& problem, const TeamPlannerOptions& options, Rng rng)
    : problem_(problem),
      options_(options),
      rng_(rng),
      forecaster_(problem.members.front().actions->step_s(), problem.tail_s) {
  assert(!problem.members.empty());
  Course greedy(problem_);
  complete(greedy, false);
  reference_s_ = 1.1 * keep_if_better(greedy);
  nodes_.emplace_back();
}

void TeamPlanner::run(int rollouts, const std::function<bool()>& stop) {
  for (int i = 0; i < rollouts && !(stop && stop()); ++i) rollout();
}

void TeamPlanner::complete(Course& course, bool randomly) {
  for (int member = course.next_member(); member >= 0; member = course.next_member()) {
    const auto choices = course.choices(member, options_.eligible);
    std::size_t chosen = 0;
    if (randomly) {
      std::size_t good = 1;
      while (good < choices.size() && choices[good].score >= (1.0 - options_.rollout_spread) * choices[0].score) ++good;
      chosen = rng_.index(good);
    }
    course.choose(member, choices[chosen].place);
  }
}

double TeamPlanner::keep_if_better(const Course& course) {
  JointPlan plan = evaluated(problem_, course.places(), forecaster_);
  const double value_s = plan.value_s;
  if (!has_best_ || value_s < best_.value_s) {
    best_ = std::move(plan);
    has_best_ = true;
  }
  return value_s;
}

std::size_t TeamPlanner::child_to_try(const Node& node) const {
  const double spread_s = std::max(1e-9, reference_s_ - best_.value_s);
  std::size_t best = 0;
  double best_score = -1.0;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Child& child = node.children[i];
    const int visits = child.node < 0 ? 0 : nodes_[static_cast<std::size_t>(child.node)].visits;
    double worth = kUntried;
    if (visits > 0) {
      worth = std::clamp((reference_s_ - nodes_[static_cast<std::size_t>(child.node)].best_s) / spread_s, 0.0, 1.0);
    }
    const double score = worth + options_.exploration * child.prior * static_cast<double>(node.children.size()) *
                                     std::sqrt(node.visits + 1.0) / (1.0 + visits);
    if (score > best_score) {
      best_score = score;
      best = i;
    }
  }
  return best;
}

void TeamPlanner::rollout() {
  Course course(problem_);
  std::vector<std::size_t> visited{0};
  // Down the tree to a node that was not expanded yet.
  while (nodes_[visited.back()].expanded && nodes_[visited.back()].member >= 0) {
    const std::size_t at = visited.back();
    const std::size_t i = child_to_try(nodes_[at]);
    course.choose(nodes_[at].member, nodes_[at].children[i].choice.place);
    if (nodes_[at].children[i].node < 0) {
      nodes_[at].children[i].node = static_cast<int>(nodes_.size());
      nodes_.emplace_back();
    }
    visited.push_back(static_cast<std::size_t>(nodes_[at].children[i].node));
  }
  Node& leaf = nodes_[visited.back()];
  if (!leaf.expanded) {
    leaf.expanded = true;
    leaf.member = course.next_member();
    if (leaf.member >= 0) {
      double sum = 0.0;
      for (const Choice& choice : course.choices(leaf.member, options_.eligible)) {
        leaf.children.push_back({choice, choice.score, -1});
        sum += choice.score;
      }
      for (Child& child : leaf.children) {
        child.prior = sum > 0.0 ? child.prior / sum : 1.0 / static_cast<double>(leaf.children.size());
      }
    }
  }
  complete(course, true);
  const double value_s = keep_if_better(course);
  for (const std::size_t index : visited) {
    Node& node = nodes_[index];
    node.best_s = node.visits == 0 ? value_s : std::min(node.best_s, value_s);
    ++node.visits;
  }
  ++rollouts_;
}

JointPlan TeamPlanner::best() {
  JointPlan plan = best_;
  add_paths(problem_, forecaster_, plan);
  return plan;
}

}  // namespace tandem
