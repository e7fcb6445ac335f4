#include "services/planner/core/tasks/task_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "services/planner/core/tasks/stations.hpp"

namespace tandem {
namespace {

constexpr double kGreedyImpatience[] = {1.0, 0.5, 1.5, 0.0};
constexpr double kSharpness = 3.0;      ///< a random course takes decisions by score to this power
constexpr double kShareUniform = 0.05;  ///< of random decisions that do not look at the score
constexpr double kLeastPrior = 1e-3;
constexpr std::int64_t kWalkDownEvery = 4;   ///< rollouts; the others change a plan
constexpr std::size_t kMostMoments = 30000;  ///< of courses kept, some 50 MB
constexpr double kHeat = 0.02;               ///< of annealing, as a share of the best value
constexpr double kShareBackToBest = 0.005;   ///< of changes that start from the best plan again

}  // namespace

TaskTree::TaskTree(TaskModel& model, TaskIncumbent& incumbent, const TaskTreeOptions& options)
    : model_(model),
      incumbent_(incumbent),
      options_(options),
      bound_of_(model),
      score_(model),
      courses_(model, model.start()) {
  add_node(courses_.state(TaskCourses::kStart));
}

std::int32_t TaskTree::add_node(TaskState state) {
  std::int32_t number = static_cast<std::int32_t>(nodes_.size());
  if (free_nodes_.empty()) {
    nodes_.emplace_back();
  } else {
    number = free_nodes_.back();
    free_nodes_.pop_back();
    nodes_[static_cast<std::size_t>(number)] = Node{};
  }
  Node& node = nodes_[static_cast<std::size_t>(number)];
  node.bound = bound_of_(state);
  node.best = -std::numeric_limits<double>::infinity();
  node.state = std::move(state);
  return number;
}

void TaskTree::expand(Node& node) {
  node.is_expanded = true;
  model_.actions(node.state, actions_);
  double sum = 0.0;
  for (const TaskAction& action : actions_) {
    const double prior = std::sqrt(score_(node.state, action, 1.0));
    node.children.push_back({action, prior, -1});
    sum += prior;
  }
  for (Child& child : node.children) child.prior = std::max(kLeastPrior, child.prior / sum);
  std::ranges::stable_sort(node.children, [](const Child& a, const Child& b) { return a.prior > b.prior; });
}

std::size_t TaskTree::select(const Node& node) const {
  const double high = std::max(incumbent_.value(), nodes_.front().bound);
  const double range = std::max(1e-9, high - lowest_);
  const double root = std::sqrt(static_cast<double>(node.visits + 1));
  const auto width = static_cast<std::size_t>(
      1.0 + options_.widening * std::pow(static_cast<double>(node.visits), options_.widening_exponent));
  std::size_t best = node.children.size();
  double best_urgency = 0.0;
  std::size_t open = 0;
  for (std::size_t i = 0; i < node.children.size() && open < width; ++i) {
    const Child& child = node.children[i];
    double value = node.best;
    int visits = 0;
    if (child.node >= 0) {
      const Node& below = nodes_[static_cast<std::size_t>(child.node)];
      if (below.is_closed) continue;
      value = std::max(below.best, lowest_);
      visits = below.visits;
    }
    ++open;
    const double urgency =
        (std::max(value, lowest_) - lowest_) / range + options_.exploration * child.prior * root / (1.0 + visits);
    if (best == node.children.size() || urgency > best_urgency) {
      best = i;
      best_urgency = urgency;
    }
  }
  return best;
}

/// Takes its subtree, which nobody will look at again, out of memory.
void TaskTree::close(Node& node) {
  node.is_closed = true;
  for (const Child& child : node.children) {
    if (child.node < 0) continue;
    Node& below = nodes_[static_cast<std::size_t>(child.node)];
    close(below);
    free_nodes_.push_back(child.node);
  }
  node.children.clear();
  node.children.shrink_to_fit();
  node.state.rewards = {};
}

/// Goes on from `state` to the end and offers the plan; gives its value. `choice` picks one of actions_.
template <typename Choice>
double TaskTree::finish(TaskState state, std::vector<TaskAction>& decisions, const Choice& choice) {
  while (model_.decider(state) != TaskModel::kNobody) {
    model_.actions(state, actions_);
    decisions.push_back(actions_[choice(state)]);
    state = model_.after(state, decisions.back());
  }
  return offered(decisions, state);
}

double TaskTree::offered(const std::vector<TaskAction>& decisions, const TaskState& final_state) {
  incumbent_.offer(decisions, final_state);
  if (!has_values_ || final_state.value < lowest_) lowest_ = final_state.value;
  has_values_ = true;
  return final_state.value;
}

std::size_t TaskTree::greedy_choice(const TaskState& state, const std::vector<TaskAction>& actions, double impatience) {
  scores_.clear();
  for (const TaskAction& action : actions) scores_.push_back(score_(state, action, impatience));
  return static_cast<std::size_t>(std::ranges::max_element(scores_) - scores_.begin());
}

std::size_t TaskTree::random_choice(const TaskState& state, double impatience, Rng& rng) {
  if (rng.uniform() < kShareUniform) return rng.index(actions_.size());
  scores_.clear();
  double sum = 0.0;
  for (const TaskAction& action : actions_) {
    scores_.push_back(std::pow(score_(state, action, impatience), kSharpness));
    sum += scores_.back();
  }
  double draw = rng.uniform() * sum;
  std::size_t chosen = 0;
  while (chosen + 1 < scores_.size() && draw >= scores_[chosen]) draw -= scores_[chosen++];
  return chosen;
}

double TaskTree::finish_at_random(TaskState state, std::vector<TaskAction>& decisions, Rng& rng) {
  const double impatience = rng.uniform(0.2, 1.6);
  return finish(std::move(state), decisions, [&](const TaskState& now) { return random_choice(now, impatience, rng); });
}

void TaskTree::offer_greedy_plans() {
  for (const double impatience : kGreedyImpatience) {
    std::vector<TaskAction> decisions;
    (void)finish(courses_.state(TaskCourses::kStart), decisions,
                 [&](const TaskState& state) { return greedy_choice(state, actions_, impatience); });
  }
}

/// From the start, everybody goes through its sequence, messages as given, then greedily on.
double TaskTree::finish_as_in(const TaskSequences& sequences, std::int32_t told, std::vector<TaskAction>& decisions) {
  if (courses_.size() >= kMostMoments) courses_.forget();
  next_in_sequence_.assign(sequences.size(), 0);
  decisions.clear();
  std::int32_t moment = TaskCourses::kStart;
  for (int agent = 0; (agent = model_.decider(courses_.state(moment))) != TaskModel::kNobody;) {
    const std::vector<TaskAction>& actions = courses_.actions(moment);
    int chosen = -1;
    if (agent == TaskModel::kTeller) {
      chosen = told;
    } else if (const auto a = static_cast<std::size_t>(agent); a < sequences.size()) {
      chosen = following(sequences[a], next_in_sequence_[a], actions);
    }
    if (chosen < 0) {
      std::int32_t& greedy = courses_.noted_choice(moment);
      if (greedy < 0) greedy = static_cast<std::int32_t>(greedy_choice(courses_.state(moment), actions, 1.0));
      chosen = greedy;
    }
    decisions.push_back(actions[static_cast<std::size_t>(chosen)]);
    moment = courses_.after(moment, static_cast<std::size_t>(chosen));
  }
  return offered(decisions, courses_.state(moment));
}

void TaskTree::offer_plan_in_execution() {
  const auto& ids = model_.problem().in_execution;
  if (ids.empty()) return;
  TaskSequences sequences(ids.size());
  for (std::size_t a = 0; a < ids.size(); ++a) {
    for (const std::string& id : ids[a]) {
      const auto source = index_of(model_.problem().world, id);
      if (!source) continue;  // removed since
      TaskAction action;
      action.kind =
          is_moving(model_.world().sources()[*source].boundary) ? TaskActionKind::Accompany : TaskActionKind::Visit;
      action.source = static_cast<std::int16_t>(*source);
      sequences[a].push_back(action);
    }
  }
  std::vector<TaskAction> decisions;
  (void)finish_as_in(sequences, 0, decisions);
}

/// Simulated annealing over the agents' sequences, from the best plan and back to it now and then.
void TaskTree::change_current(Rng& rng) {
  if (current_.empty() || rng.uniform() < kShareBackToBest) {
    current_ = incumbent_.decisions();
    current_value_ = incumbent_.value();
    if (current_.empty()) return walk_down(rng);
  }
  TaskSequences sequences = sequences_of(current_, model_.agent_count());
  change(sequences, model_.world().sources().size(), rng);
  const std::int32_t told = current_.front().kind == TaskActionKind::Tell ? current_.front().source : 0;
  const double value = finish_as_in(sequences, told, changed_);
  const double heat = kHeat * std::abs(incumbent_.value());
  if (value < current_value_ + heat * std::log(1.0 - rng.uniform())) return;
  std::swap(current_, changed_);
  current_value_ = value;
}

void TaskTree::roll_out(Rng& rng) {
  if (is_finished()) return;
  if (++rollouts_ % kWalkDownEvery == 0) {
    walk_down(rng);
  } else {
    change_current(rng);
  }
}

void TaskTree::walk_down(Rng& rng) {
  std::vector<std::int32_t> path{0};
  std::vector<TaskAction> decisions;
  double value = -std::numeric_limits<double>::infinity();
  while (true) {
    Node& node = nodes_[static_cast<std::size_t>(path.back())];
    if (model_.decider(node.state) == TaskModel::kNobody) {
      incumbent_.offer(decisions, node.state);
      value = node.state.value;
      node.bound = value;
      close(node);
      break;
    }
    if (!node.is_expanded) {
      if (!incumbent_.can_be_beaten_by(node.bound, model_.least_makespan_ms(node.state))) {
        close(node);
        break;
      }
      if (node.visits == 0 && path.size() > 1) {
        value = finish_at_random(node.state, decisions, rng);
        break;
      }
      expand(node);
    }
    const std::size_t chosen = select(node);
    if (chosen == node.children.size()) break;  // all closed: found out while backing up
    Child& child = node.children[chosen];
    if (child.node < 0) {
      if (nodes_.size() - free_nodes_.size() >= options_.most_nodes) {
        value = finish_at_random(node.state, decisions, rng);
        break;
      }
      child.node = add_node(model_.after(node.state, child.action));
    }
    decisions.push_back(child.action);
    path.push_back(child.node);
  }
  back_up(path, value);
}

void TaskTree::back_up(const std::vector<std::int32_t>& path, double value) {
  for (std::size_t i = path.size(); i-- > 0;) {
    Node& node = nodes_[static_cast<std::size_t>(path[i])];
    ++node.visits;
    node.best = std::max(node.best, value);
    if (!node.is_expanded || node.is_closed) continue;
    double bound = -std::numeric_limits<double>::infinity();
    bool all_closed = true;
    for (Child& child : node.children) {
      if (child.node < 0) {
        all_closed = false;
        bound = std::max(bound, node.bound);
        continue;
      }
      Node& below = nodes_[static_cast<std::size_t>(child.node)];
      all_closed &= below.is_closed;
      bound = std::max(bound, below.bound);
    }
    node.bound = std::min(node.bound, bound);
    if (all_closed || !incumbent_.can_be_beaten_by(node.bound, model_.least_makespan_ms(node.state))) close(node);
  }
}

}  // namespace tandem
