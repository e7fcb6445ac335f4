#include <algorithm>
#include <cmath>

#include "services/planner/core/tasks/stations.hpp"
#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {
namespace {

constexpr std::size_t kNextSources = 8;  ///< so many sources a stay may end in time for
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min() / 2;

/// How long it takes to draw so much at such a rate [ms].
std::int64_t drawing_ms(double amount, double draw_per_s) {
  return static_cast<std::int64_t>(std::ceil(amount / draw_per_s * 1000.0 - 1e-6));
}

}  // namespace

void TaskModel::actions(const TaskState& state, std::vector<TaskAction>& out) {
  out.clear();
  const int deciding = decider(state);
  if (deciding == kNobody) return;
  if (deciding == kTeller) {
    for (std::size_t i = 0; i < messages_.size(); ++i) {
      TaskAction& action = out.emplace_back();
      action.kind = TaskActionKind::Tell;
      action.source = static_cast<std::int16_t>(i);
    }
    return;
  }
  const auto agent = static_cast<std::size_t>(deciding);
  add_visits(state, agent, out);
  TaskAction action;
  action.agent = static_cast<std::int16_t>(agent);
  const bool has_goal = goal_places_[agent] && leads_to_goal(state, agent);
  if (has_goal) {
    action.kind = TaskActionKind::Goal;
    action.place = *goal_places_[agent];
    out.push_back(action);
    return;  // nothing that may last until it is too late for the goal
  }
  add_accompanying(state, agent, out);
  if (may_hold(state, agent)) {
    action.kind = TaskActionKind::Hold;
    out.push_back(action);
  }
  action.kind = TaskActionKind::Wait;
  out.push_back(action);
}

/// Whether the agent can get to the goal that was fixed for it at all.
bool TaskModel::leads_to_goal(const TaskState& state, std::size_t agent) {
  const int from = place_of(agent, state.agents[agent]);
  return from >= 0 && !travels_[agent].ways(from, *goal_places_[agent]).empty();
}

void TaskModel::add_visits(const TaskState& state, std::size_t agent, std::vector<TaskAction>& out) {
  const TaskAgentState& one = state.agents[agent];
  const int from = place_of(agent, one);
  if (from < 0) return;
  for (std::size_t s = 0; s < world_.sources().size(); ++s) {
    if (stations_[agent][s].empty() || !is_known(state, s, agent) || !is_hopeful(state, s, agent)) continue;
    const auto nearest = nearest_station(agent, s, from);
    if (!nearest) continue;
    // The nearest station, and the middle where more is paid than at the edge.
    std::array<int, 2> places{*nearest, -1};
    const Station& middle = stations_[agent][s].front();
    if (middle.place != *nearest && !is_constant(world_.sources()[s].inside)) places[1] = middle.place;
    for (const int place : places) {
      if (place < 0) continue;
      const auto ways = travels_[agent].ways(from, place).size();
      for (std::size_t w = 0; w < ways; ++w) {
        TaskAction action;
        action.kind = TaskActionKind::Visit;
        action.agent = static_cast<std::int16_t>(agent);
        action.source = static_cast<std::int16_t>(s);
        action.way = static_cast<std::int16_t>(w);
        action.place = place;
        const std::int64_t latest_ms = limits_ms_[agent] - way_to_goal_ms(agent, place);
        const std::int64_t arrival = arrival_ms(state, action);
        if (arrival < latest_ms || (arrival == latest_ms && arrival > state.now_ms)) {
          add_stays(state, action, latest_ms, out);
        }
      }
    }
  }
}

/// The visit with all ends of its stay that differ.
void TaskModel::add_stays(const TaskState& state, TaskAction action, std::int64_t latest_ms,
                          std::vector<TaskAction>& out) {
  const auto agent = static_cast<std::size_t>(action.agent);
  const auto s = static_cast<std::size_t>(action.source);
  out.push_back(action);
  const std::size_t pool = world_.sources()[s].pool;
  const bool is_trigger = std::ranges::any_of(gates_of_pool_[pool], [&](std::size_t g) {
    const ResolvedGate& gate = world_.gates()[g];
    return state.rewards.through[g] == 0 && (gate.on_entry || gate.amount < std::abs(world_.pools()[pool].size));
  });
  if (is_trigger) {
    action.until = StayEnd::Triggered;
    out.push_back(action);
  }
  const std::int64_t arrival = arrival_ms(state, action);
  const double draw = draw_per_s(agent, s, action.place);
  const double all_of_it = left(state, s);
  const bool is_open = is_opened(world_.sources()[s], state.rewards);
  const std::int64_t done_ms = is_open && std::isfinite(all_of_it) ? arrival + drawing_ms(all_of_it, draw)
                                                                   : std::numeric_limits<std::int64_t>::max();
  if (done_ms <= arrival) return;
  action.until = StayEnd::InTimeFor;
  find_next_sources(state, agent, s, action.place);
  for (const auto& [distance_m, next] : next_sources_) {
    const std::int64_t leave_ms = latest_leave_ms(agent, action.place, next, left(state, next));
    if (leave_ms <= arrival || leave_ms >= std::min(done_ms, latest_ms)) continue;
    action.next = static_cast<std::int16_t>(next);
    out.push_back(action);
  }
}

/// The sources nearest to a station of `source` that may be consumed after it.
void TaskModel::find_next_sources(const TaskState& state, std::size_t agent, std::size_t source, int place) {
  next_sources_.clear();
  for (std::size_t next = 0; next < world_.sources().size(); ++next) {
    if (next == source || stations_[agent][next].empty() || !std::isfinite(left(state, next))) continue;
    if (!is_known(state, next, agent) || !is_hopeful(state, next, agent)) continue;
    const Eigen::Vector2d& middle = travels_[agent].point(stations_[agent][next].front().place);
    next_sources_.emplace_back((middle - travels_[agent].point(place)).norm(), next);
  }
  std::ranges::sort(next_sources_);
  if (next_sources_.size() > kNextSources) next_sources_.resize(kNextSources);
}

double TaskModel::draw_per_s(std::size_t agent, std::size_t source, int place) const {
  for (const Station& station : stations_[agent][source]) {
    if (station.place == place) return station.draw_per_s;
  }
  return 0.0;
}

void TaskModel::add_accompanying(const TaskState& state, std::size_t agent, std::vector<TaskAction>& out) const {
  if (!has_moving_sources_ || state.now_ms >= limits_ms_[agent]) return;
  for (std::size_t s = 0; s < world_.sources().size(); ++s) {
    const ResolvedSource& source = world_.sources()[s];
    if (!is_moving(source.boundary) || peak_of(source.inside) <= 0.0) continue;
    if (!is_known(state, s, agent) || !is_hopeful(state, s, agent)) continue;
    TaskAction action;
    action.kind = TaskActionKind::Accompany;
    action.agent = static_cast<std::int16_t>(agent);
    action.source = static_cast<std::int16_t>(s);
    out.push_back(action);
  }
}

/// Holding is for those who had better let a mate go first, or do not know yet where the mate will go.
bool TaskModel::may_hold(const TaskState& state, std::size_t agent) const {
  if (!has_soft_relations_ && !has_moving_sources_) return false;
  for (std::size_t a = 0; a < agent_count(); ++a) {
    const Occupation occupation = state.agents[a].occupation;
    if (a != agent && occupation != Occupation::Done && occupation != Occupation::Holding) return true;
  }
  return false;
}

std::int64_t TaskModel::arrival_ms(const TaskState& state, const TaskAction& action) {
  const auto agent = static_cast<std::size_t>(action.agent);
  const TaskAgentState& one = state.agents[agent];
  if (action.place < 0) return state.now_ms;
  return state.now_ms + leg(agent, place_of(agent, one), action.place, action.way, one.heading_rad)->duration_ms();
}

double TaskModel::hazard_cost(const TaskState& state, const TaskAction& action) {
  const auto agent = static_cast<std::size_t>(action.agent);
  if (action.place < 0) return 0.0;
  const auto& ways = travels_[agent].ways(place_of(agent, state.agents[agent]), action.place);
  return ways[static_cast<std::size_t>(action.way)].hazard / problem_.agents[agent].searcher.speed_mps;
}

std::optional<int> TaskModel::nearest_station(std::size_t agent, std::size_t source, int from_place) {
  const auto [found, is_new] = nearest_stations_[agent].try_emplace({from_place, source});
  if (!is_new) return found->second;
  std::optional<int> nearest;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Station& station : stations_[agent][source]) {
    const Eigen::Vector2d& point = travels_[agent].point(station.place);
    if ((point - travels_[agent].point(from_place)).norm() >= nearest_m) continue;
    const auto& ways = travels_[agent].ways(from_place, station.place);
    if (ways.empty() || ways.front().length_m >= nearest_m) continue;
    nearest_m = ways.front().length_m;
    nearest = station.place;
  }
  found->second = nearest;
  return nearest;
}

/// When to leave a place to consume all of `next` before time is up [ms]; kNever if that takes for ever.
std::int64_t TaskModel::latest_leave_ms(std::size_t agent, int from_place, std::size_t next, double next_left) {
  const auto station = nearest_station(agent, next, from_place);
  if (!station || !std::isfinite(next_left)) return kNever;
  const double draw = draw_per_s(agent, next, *station);
  const auto& way = travels_[agent].ways(from_place, *station).front();
  const std::int64_t way_ms = drawing_ms(way.length_m, problem_.agents[agent].searcher.speed_mps);
  return limits_ms_[agent] - way_to_goal_ms(agent, *station) - drawing_ms(next_left, draw) - way_ms;
}

/// How long it takes from the place to the goal the agent was given [ms]; 0 without one.
std::int64_t TaskModel::way_to_goal_ms(std::size_t agent, int from_place) {
  if (!goal_places_[agent]) return 0;
  const auto& ways = travels_[agent].ways(from_place, *goal_places_[agent]);
  if (ways.empty()) return 0;
  return drawing_ms(ways.front().length_m, problem_.agents[agent].searcher.speed_mps);
}

}  // namespace tandem
