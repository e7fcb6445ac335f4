#include "services/planner/core/team/team_planner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tandem {
namespace {

constexpr double kUntried = 0.5;  ///< what an untried action is taken to be worth, between reference (0) and best (1)

}  // namespace

void TeamPlanner::begin(const SearchProblem& problem, Rng rng) {
  assert(!problem.members.empty() && !problem.masses.empty());
  rng_ = rng;
  problem_ = std::make_unique<PreparedProblem>(problem);
  objective_.emplace(problem.masses, problem.horizon_s, problem.tail_s);
  nodes_.assign(1, {});
  rollouts_ = 0;
  Course greedy(*problem_);
  complete(greedy, false);
  best_ = greedy.routes();
  best_value_s_ = value_s(best_);
  reference_s_ = 1.1 * best_value_s_;
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

double TeamPlanner::value_s(const Routes& routes) {
  looks_ = problem_->fixed_looks();
  for (std::size_t m = 0; m < routes.size(); ++m) problem_->add_looks(m, routes[m], looks_);
  const double expected_s = objective_->forecast(looks_).expected_time_s;
  const auto& rejected = problem_->problem().rejected;
  if (rejected.empty()) return expected_s;
  std::vector<TimedPath> paths;
  for (std::size_t m = 0; m < routes.size(); ++m) paths.push_back(problem_->path(m, routes[m]));
  const bool is_rejected = std::ranges::any_of(rejected, [&](const auto& plan) { return is_like(paths, plan); });
  return is_rejected ? expected_s + kRejectedPenalty_s : expected_s;
}

double TeamPlanner::keep_if_better(const Course& course) {
  const double value = value_s(course.routes());
  if (value < best_value_s_) {
    best_ = course.routes();
    best_value_s_ = value;
  }
  return value;
}

std::size_t TeamPlanner::child_to_try(const Node& node) const {
  const double spread_s = std::max(1e-9, reference_s_ - best_value_s_);
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
  Course course(*problem_);
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
  return problem_->plan(best_);
}

}  // namespace tandem
