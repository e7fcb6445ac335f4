#include "services/planner/core/team/joint_tree.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kUntried = 0.5;  ///< what an untried action is taken to be worth, between worst (0) and best (1)
constexpr double kFirstSpread = 1.1;
constexpr std::uint32_t kFirstChildren = 3;

}  // namespace

JointTree::JointTree(const TeamGround& ground, RouteValue& value, const JointTreeOptions& options,
                     const WalkOptions& walk)
    : value_(&value), options_(options), walk_(ground, walk), nodes_(1), next_(ground.books.size()) {}

void JointTree::expand(std::size_t index) {
  nodes_[index].expanded = true;
  const int member = walk_.next_member();
  nodes_[index].member = member;
  if (member < 0) return;
  nodes_[index].first_child = static_cast<std::uint32_t>(children_.size());
  double sum = 0.0;
  const auto choices = walk_.choices(member, options_.eligible);
  for (const Choice& choice : choices) sum += choice.score;
  for (const Choice& choice : choices) {
    children_.push_back({choice, sum > 0.0 ? choice.score / sum : 1.0 / static_cast<double>(choices.size()), -1});
  }
  nodes_[index].children = static_cast<std::uint32_t>(choices.size());
}

std::size_t JointTree::child_to_try(const Node& node) const {
  const double spread_s = std::max(1e-9, worst_s_ - best_s_);
  std::size_t best = node.first_child;
  double best_score = -1.0;
  const auto widened = kFirstChildren + static_cast<std::uint32_t>(std::sqrt(node.visits));
  const auto consider = [&](std::size_t index) {
    const Child& child = children_[index];
    const int visits = child.node < 0 ? 0 : nodes_[static_cast<std::size_t>(child.node)].visits;
    double worth = kUntried;
    if (visits > 0) {
      worth = std::clamp((worst_s_ - nodes_[static_cast<std::size_t>(child.node)].best_s) / spread_s, 0.0, 1.0);
    }
    const double score =
        worth + options_.exploration * child.prior * node.children * std::sqrt(node.visits + 1.0) / (1.0 + visits);
    if (score > best_score) {
      best_score = score;
      best = index;
    }
  };
  for (std::uint32_t i = 0; i < node.children; ++i) {
    if (i < widened || children_[node.first_child + i].node >= 0) consider(node.first_child + i);
  }
  if (node.extra >= 0) consider(static_cast<std::size_t>(node.extra));
  return best;
}

std::size_t JointTree::node_of(std::size_t child) {
  if (children_[child].node < 0) {
    children_[child].node = static_cast<std::int32_t>(nodes_.size());
    nodes_.emplace_back();
  }
  return static_cast<std::size_t>(children_[child].node);
}

void JointTree::learn(double value_s) {
  if (worst_s_ == 0.0) worst_s_ = kFirstSpread * value_s;
  best_s_ = best_s_ == 0.0 ? value_s : std::min(best_s_, value_s);
  for (const std::size_t index : visited_) {
    Node& node = nodes_[index];
    node.best_s = node.visits == 0 ? value_s : std::min(node.best_s, value_s);
    ++node.visits;
  }
}

double JointTree::rollout(Rng& rng) {
  walk_.restart();
  visited_.assign(1, 0);
  while (nodes_[visited_.back()].expanded && nodes_[visited_.back()].member >= 0 &&
         static_cast<int>(visited_.size()) <= options_.deepest) {
    const Node& node = nodes_[visited_.back()];
    const std::size_t child = child_to_try(node);
    walk_.choose(node.member, children_[child].choice.place);
    visited_.push_back(node_of(child));
  }
  if (!nodes_[visited_.back()].expanded) expand(visited_.back());
  for (int member = walk_.next_member(); member >= 0; member = walk_.next_member()) {
    const auto choices = walk_.choices(member, options_.eligible);
    std::size_t good = 1;
    const double enough = (1.0 - options_.rollout_spread) * choices[0].score;
    while (good < choices.size() && choices[good].score >= enough) ++good;
    walk_.choose(member, choices[rng.index(good)].place);
  }
  const double value_s = value_->value_s(walk_.routes());
  learn(value_s);
  return value_s;
}

void JointTree::remember(const Routes& routes, double value_s) {
  walk_.restart();
  std::ranges::fill(next_, 0U);
  visited_.assign(1, 0);
  while (static_cast<int>(visited_.size()) <= options_.deepest) {
    const std::size_t at = visited_.back();
    if (!nodes_[at].expanded) expand(at);
    if (nodes_[at].member < 0) break;
    const auto m = static_cast<std::size_t>(nodes_[at].member);
    const int place = next_[m] < routes[m].size() ? routes[m][next_[m]++] : -1;
    std::size_t child = children_.size();
    for (std::uint32_t i = 0; i < nodes_[at].children; ++i) {
      if (children_[nodes_[at].first_child + i].choice.place == place) child = nodes_[at].first_child + i;
    }
    if (child == children_.size()) {
      const bool known =
          nodes_[at].extra >= 0 && children_[static_cast<std::size_t>(nodes_[at].extra)].choice.place == place;
      if (known) {
        child = static_cast<std::size_t>(nodes_[at].extra);
      } else {
        nodes_[at].extra = static_cast<std::int32_t>(child);
        children_.push_back({{place, 0.0F, 0.0F}, 1.0 / options_.eligible, -1});
      }
    }
    walk_.choose(nodes_[at].member, place);
    visited_.push_back(node_of(child));
  }
  learn(value_s);
}

}  // namespace tandem
