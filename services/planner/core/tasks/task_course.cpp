#include <algorithm>
#include <cmath>

#include "services/planner/core/tasks/stations.hpp"
#include "services/planner/core/tasks/task_model.hpp"

// How time goes on between two decisions.

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr std::int64_t kAccompanyStep_ms = 200;  ///< who accompanies a mate looks where it is so often

bool is_on_way(const TaskAgentState& agent, std::int64_t now_ms) {
  return agent.leg != nullptr && now_ms < agent.arrival_ms() &&
         (agent.occupation == Occupation::Committed || agent.occupation == Occupation::Visiting ||
          agent.occupation == Occupation::GoingToGoal);
}

}  // namespace

void TaskModel::begin(TaskState& state, const TaskAction& action) {
  const auto agent = static_cast<std::size_t>(action.agent);
  TaskAgentState& one = state.agents[agent];
  one.action = action;
  const std::int64_t limit_ms = limits_ms_[agent];
  switch (action.kind) {
    case TaskActionKind::Visit:
    case TaskActionKind::Goal: {
      const int from = place_of(agent, one);
      one.leg = leg(agent, from, action.place, action.way, one.heading_rad);
      one.leg_start_ms = state.now_ms;
      one.place = action.place;
      one.occupation = action.kind == TaskActionKind::Goal ? Occupation::GoingToGoal : Occupation::Visiting;
      one.leave_ms = limit_ms - way_to_goal_ms(agent, action.place);
      if (action.until == StayEnd::InTimeFor) {
        const auto next = static_cast<std::size_t>(action.next);
        one.leave_ms = std::min(one.leave_ms, latest_leave_ms(agent, action.place, next, left(state, next)));
      }
      break;
    }
    case TaskActionKind::Accompany:
      one.occupation = Occupation::Accompanying;
      one.leg = nullptr;
      one.leg_start_ms = state.now_ms;
      one.leave_ms = limit_ms;
      one.place = -1;
      break;
    case TaskActionKind::Hold:
      one.occupation = Occupation::Holding;
      break;
    default:
      one.occupation = Occupation::Done;
  }
}

void TaskModel::run(TaskState& state) {
  while (state.now_ms < horizon_ms_ && decider(state) == kNobody) step(state);
}

void TaskModel::step(TaskState& state) {
  std::int64_t until_ms = horizon_ms_;
  for (std::size_t a = 0; a < agent_count(); ++a) until_ms = std::min(until_ms, next_change_ms(state, a));
  advance(state, std::max(until_ms, state.now_ms));
  end_actions(state);
  if (observer_ != nullptr) observer_->on_step(state);
}

/// When the agent next turns a corner or ends a stay, if nothing happens to the pools.
std::int64_t TaskModel::next_change_ms(const TaskState& state, std::size_t agent) const {
  const TaskAgentState& one = state.agents[agent];
  if (is_on_way(one, state.now_ms)) {
    for (const auto& point : one.leg->points) {
      if (one.leg_start_ms + point.time_ms > state.now_ms) return one.leg_start_ms + point.time_ms;
    }
  }
  if (one.occupation == Occupation::Visiting) return std::max(one.leave_ms, state.now_ms);
  if (one.occupation == Occupation::Accompanying) return std::min(one.leave_ms, state.now_ms + kAccompanyStep_ms);
  if (one.occupation == Occupation::Committed || one.occupation == Occupation::GoingToGoal) return state.now_ms;
  return horizon_ms_;
}

/// What the agent does until `until_ms`, no later than its next change, if it does not accompany anybody.
AgentMove TaskModel::move_of(const TaskState& state, std::size_t agent, std::int64_t until_ms) const {
  const TaskAgentState& one = state.agents[agent];
  AgentMove move = stay_at(one.point_in_map, one.heading_rad);
  if (is_on_way(one, state.now_ms)) {
    const auto& points = one.leg->points;
    const std::int64_t on_leg_ms = state.now_ms - one.leg_start_ms;
    const auto next = std::ranges::upper_bound(points, on_leg_ms, {}, &TaskLeg::Point::time_ms);
    const auto before = std::prev(next);
    const double whole_ms = static_cast<double>(next->time_ms - before->time_ms);
    const double from = static_cast<double>(on_leg_ms - before->time_ms) / whole_ms;
    const double to = static_cast<double>(until_ms - one.leg_start_ms - before->time_ms) / whole_ms;
    AgentMove piece = straight_move(before->point_in_map, next->point_in_map);
    piece.from_heading_rad = next->from_heading_rad;
    piece.to_heading_rad = next->to_heading_rad;
    move = part_of(piece, from, to);
  }
  move.from_altitude_m = move.to_altitude_m = problem_.agents[agent].altitude_m;
  return move;
}

/// One step of an agent towards where the source it accompanies will be at the end of it. moves_ holds the others'.
AgentMove TaskModel::move_with(const TaskState& state, std::size_t agent, std::int64_t until_ms) {
  const TaskAgentState& one = state.agents[agent];
  const Searcher& searcher = problem_.agents[agent].searcher;
  const ResolvedSource& source = world_.sources()[static_cast<std::size_t>(one.action.source)];
  std::array<AgentMove, kMaxTaskAgents> ends;
  for (std::size_t a = 0; a < agent_count(); ++a) ends[a] = part_of(moves_[a], 1.0, 1.0);
  const double duration_s = static_cast<double>(until_ms - state.now_ms) * 1e-3;
  Vector2d target = moving_station(source.boundary, {{ends.data(), agent_count()}, duration_s});
  if (!travels_[agent].is_clear(one.point_in_map, target)) {
    // Not straight: the first piece of the way there, or no step at all where none leads.
    const auto from = travels_[agent].place_at(one.point_in_map, 1.0);
    const auto to = travels_[agent].place_at(target, 1.0);
    const bool leads = from && to && !travels_[agent].ways(*from, *to).empty();
    target = leads ? travels_[agent].ways(*from, *to).front().points_in_map[1] : one.point_in_map;
  }
  const Vector2d way = target - one.point_in_map;
  const double reach_m = searcher.speed_mps * duration_s;
  const double length_m = way.norm();
  AgentMove move = stay_at(one.point_in_map, one.heading_rad);
  if (length_m > 1e-9) {
    move.to_in_map = one.point_in_map + way * std::min(1.0, reach_m / length_m);
    move.from_heading_rad = move.to_heading_rad = std::atan2(way.y(), way.x());
  }
  move.from_altitude_m = move.to_altitude_m = problem_.agents[agent].altitude_m;
  return move;
}

/// Lets time pass until `until_ms`, or until something happens to a pool or relation: decisions may hang on it.
void TaskModel::advance(TaskState& state, std::int64_t until_ms) {
  if (until_ms <= state.now_ms) return;
  for (std::size_t a = 0; a < agent_count(); ++a) moves_[a] = move_of(state, a, until_ms);
  for (std::size_t a = 0; a < agent_count(); ++a) {
    if (state.agents[a].occupation == Occupation::Accompanying) moves_[a] = move_with(state, a, until_ms);
  }
  for (int attempt = 0;; ++attempt) {
    account_.restore(state.rewards);
    events_.events.clear();
    std::ranges::fill(events_.paid, 0.0);
    std::ranges::fill(rewards_, 0.0);
    account_.advance(moves_, static_cast<double>(until_ms - state.now_ms) * 1e-3, rewards_);
    if (attempt > 0 || events_.events.empty()) break;
    const double first_s = events_.events.front().time_s;
    const auto first_ms = static_cast<std::int64_t>(std::ceil(first_s * 1000.0 - 1e-6));
    const std::int64_t cut_ms = std::max(first_ms, state.now_ms + 1);
    if (cut_ms >= until_ms) break;
    const double share = static_cast<double>(cut_ms - state.now_ms) / static_cast<double>(until_ms - state.now_ms);
    for (auto& move : moves_) move = part_of(move, 0.0, share);
    until_ms = cut_ms;
  }
  state.rewards = account_.state();
  for (std::size_t a = 0; a < agent_count(); ++a) {
    state.value += rewards_[a];
    state.agents[a].point_in_map = moves_[a].to_in_map;
    state.agents[a].heading_rad = moves_[a].to_heading_rad;
  }
  state.now_ms = until_ms;
  if (record_ == nullptr) return;
  record_->events.insert(record_->events.end(), events_.events.begin(), events_.events.end());
  for (std::size_t i = 0; i < events_.paid.size(); ++i) record_->paid[i] += events_.paid[i];
}

/// Whether what the agent does ends now.
bool TaskModel::is_over(const TaskState& state, std::size_t agent) const {
  const TaskAgentState& one = state.agents[agent];
  if (is_on_way(one, state.now_ms)) return false;
  switch (one.occupation) {
    case Occupation::Committed:
    case Occupation::GoingToGoal:
      return true;
    case Occupation::Visiting:
    case Occupation::Accompanying: {
      const auto s = static_cast<std::size_t>(one.action.source);
      const ResolvedSource& source = world_.sources()[s];
      if (state.now_ms >= one.leave_ms || left(state, s) <= 0.0) return true;
      if (is_silenced(source, agent, world_, state.rewards)) return true;
      if (one.action.until != StayEnd::Triggered) return false;
      return std::ranges::all_of(gates_of_pool_[source.pool],
                                 [&](std::size_t gate) { return state.rewards.through[gate] != 0; });
    }
    default:
      return false;
  }
}

void TaskModel::end_actions(TaskState& state) {
  std::uint32_t freed = 0;
  const auto end = [&](std::size_t a) {
    TaskAgentState& one = state.agents[a];
    const bool is_last = one.occupation == Occupation::GoingToGoal || state.now_ms >= limits_ms_[a] ||
                         (one.occupation == Occupation::Committed && problem_.agents[a].freedom == TaskFreedom::Fixed);
    state.makespan_ms = std::max(state.makespan_ms, state.now_ms);
    if (observer_ != nullptr) observer_->on_end(state, a);
    one.occupation = is_last ? Occupation::Done : Occupation::Free;
    freed |= mask_of(a);
  };
  for (std::size_t a = 0; a < agent_count(); ++a) {
    if (is_over(state, a)) end(a);
  }
  if (freed == 0) return;
  // Whoever waits for a mate, or goes along with one, decides again.
  const std::uint32_t leaders = freed;
  for (std::size_t a = 0; a < agent_count(); ++a) {
    TaskAgentState& one = state.agents[a];
    if (one.occupation == Occupation::Holding) one.occupation = Occupation::Free;
    if (one.occupation != Occupation::Accompanying) continue;
    const auto& boundary = world_.sources()[static_cast<std::size_t>(one.action.source)].boundary;
    for (std::size_t leader = 0; leader < agent_count(); ++leader) {
      if ((leaders & mask_of(leader)) == 0 || !moves_with(boundary, leader)) continue;
      end(a);
      break;
    }
  }
}

}  // namespace tandem
