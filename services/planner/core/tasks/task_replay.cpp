#include "services/planner/core/tasks/task_replay.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr std::int64_t kDrainStep_ms = 50;  ///< between two looks at a pool that is drawn from

double in_s(std::int64_t time_ms) {
  return static_cast<double>(time_ms) * 1e-3;
}

/// What the agent does between two states that are one step apart.
AgentMove move_between(const TaskState& from, const TaskState& to, std::size_t agent, double altitude_m) {
  const TaskAgentState& begin = from.agents[agent];
  const TaskAgentState& end = to.agents[agent];
  AgentMove move = straight_move(begin.point_in_map, end.point_in_map);
  move.from_altitude_m = move.to_altitude_m = altitude_m;
  if (begin.point_in_map == end.point_in_map) move.from_heading_rad = begin.heading_rad;
  move.to_heading_rad = end.heading_rad;
  return move;
}

/// Writes down a course of events as a plan.
class Recorder : public TaskObserver {
 public:
  Recorder(const TaskModel& model, const TaskState& start, TaskPlan& plan)
      : model_(model), plan_(plan), account_(model.world()), rewards_(model.agent_count()), before_(start) {
    plan_.agents.resize(model.agent_count());
    plan_.drains.resize(model.world().sources().size());
    add_points(start);
    add_drains(start.rewards, start.now_ms);
  }

  void on_step(const TaskState& state) override {
    add_points(state);
    if (state.rewards.left != before_.rewards.left) look_between(state);
    add_drains(state.rewards, state.now_ms);
    before_ = state;
  }

  void on_end(const TaskState& state, std::size_t agent) override {
    const TaskAgentState& one = state.agents[agent];
    TaskAgentPlan& plan = plan_.agents[agent];
    plan.end_s = in_s(state.now_ms);
    if (one.occupation != Occupation::Visiting && one.occupation != Occupation::Accompanying) return;
    const auto source = static_cast<std::size_t>(one.action.source);
    const double arrive_s = in_s(std::min(one.arrival_ms(), state.now_ms));
    const bool goes_on = one.occupation == Occupation::Accompanying && !plan.visits.empty() &&
                         plan.visits.back().source == source && plan.visits.back().leave_s == arrive_s;
    if (goes_on) {
      plan.visits.back().leave_s = in_s(state.now_ms);
    } else {
      plan.visits.push_back({source, arrive_s, in_s(state.now_ms)});
    }
  }

 private:
  void add_points(const TaskState& state) {
    for (std::size_t a = 0; a < model_.agent_count(); ++a) {
      auto& points = plan_.agents[a].path.points;
      const TimedPoint point{in_s(state.now_ms), state.agents[a].point_in_map};
      // A point on the straight line at constant speed between its neighbours says nothing.
      if (points.size() >= 2 && is_between(points[points.size() - 2], points.back(), point)) points.pop_back();
      if (points.empty() || points.back().time_s < point.time_s) points.push_back(point);
    }
  }

  /// Goes through the last step once more, slowly: a pool is drawn from only for a part of it.
  void look_between(const TaskState& state) {
    std::vector<AgentMove> moves;
    for (std::size_t a = 0; a < model_.agent_count(); ++a) {
      moves.push_back(move_between(before_, state, a, model_.problem().agents[a].altitude_m));
    }
    account_.restore(before_.rewards);
    const std::int64_t whole_ms = state.now_ms - before_.now_ms;
    std::vector<AgentMove> parts(moves.size());
    for (std::int64_t at_ms = kDrainStep_ms; at_ms < whole_ms; at_ms += kDrainStep_ms) {
      const double from = static_cast<double>(at_ms - kDrainStep_ms) / static_cast<double>(whole_ms);
      const double to = static_cast<double>(at_ms) / static_cast<double>(whole_ms);
      std::ranges::transform(moves, parts.begin(), [&](const AgentMove& move) { return part_of(move, from, to); });
      account_.advance(parts, in_s(kDrainStep_ms), rewards_);
      add_drains(account_.state(), before_.now_ms + at_ms);
    }
  }

  void add_drains(const RewardState& rewards, std::int64_t now_ms) {
    for (std::size_t s = 0; s < plan_.drains.size(); ++s) {
      const std::size_t pool = model_.world().sources()[s].pool;
      const double size = model_.world().pools()[pool].size;
      if (!std::isfinite(size)) continue;
      auto& drain = plan_.drains[s];
      const DrainPoint point{in_s(now_ms), std::copysign(rewards.left[pool], size)};
      if (drain.size() >= 2 && is_between(drain[drain.size() - 2], drain.back(), point)) drain.pop_back();
      if (drain.empty() || drain.back().time_s < point.time_s) drain.push_back(point);
    }
  }

  static bool is_between(const DrainPoint& a, const DrainPoint& b, const DrainPoint& c) {
    const double share = (b.time_s - a.time_s) / (c.time_s - a.time_s);
    return std::abs(a.left + share * (c.left - a.left) - b.left) < 1e-9;
  }

  static bool is_between(const TimedPoint& a, const TimedPoint& b, const TimedPoint& c) {
    const double share = (b.time_s - a.time_s) / (c.time_s - a.time_s);
    return (a.point_in_map + share * (c.point_in_map - a.point_in_map) - b.point_in_map).norm() < 1e-9;
  }

  const TaskModel& model_;
  TaskPlan& plan_;
  RewardAccount account_;
  std::vector<double> rewards_;
  TaskState before_;
};

}  // namespace

TaskPlan replayed(TaskModel& model, const std::vector<TaskAction>& decisions) {
  TaskPlan plan;
  model.observe(nullptr);
  model.record_to(&plan.record);
  // The start may already let time pass: until then, everybody stands at its own start.
  TaskState state;
  for (std::size_t a = 0; a < model.agent_count(); ++a) {
    state.agents[a].point_in_map = model.problem().agents[a].start.position();
  }
  state.rewards = initial_state(model.world());
  Recorder recorder{model, state, plan};
  model.observe(&recorder);
  state = model.start();
  for (const TaskAction& action : decisions) state = model.after(state, action);
  model.observe(nullptr);
  model.record_to(nullptr);
  plan.value = state.value;
  plan.makespan_s = in_s(state.makespan_ms);
  if (state.told > 0) plan.informs = model.messages()[static_cast<std::size_t>(state.told)];
  const std::size_t agents = model.agent_count();
  for (std::size_t i = 0; i < plan.record.paid.size(); ++i) plan.agents[i % agents].reward += plan.record.paid[i];
  for (TaskAgentPlan& agent : plan.agents) {
    // It waits at the end of its path.
    auto& points = agent.path.points;
    if (points.size() >= 2 && points[points.size() - 2].point_in_map == points.back().point_in_map) points.pop_back();
  }
  return plan;
}

bool walks_like(const std::vector<TimedPath>& paths, const std::vector<TimedPath>& rejected, double window_s,
                double near_m) {
  constexpr double kStep_s = 0.5;
  for (std::size_t a = 0; a < std::min(paths.size(), rejected.size()); ++a) {
    double sum_m = 0.0;
    int count = 0;
    for (double time_s = 0.0; time_s <= window_s; time_s += kStep_s, ++count) {
      sum_m += (pose_at(paths[a], time_s).position() - pose_at(rejected[a], time_s).position()).norm();
    }
    if (sum_m / count >= near_m) return false;
  }
  return true;
}

std::size_t visits_in_common(const RewardWorld& world, const std::vector<TaskAction>& decisions,
                             const std::vector<std::vector<std::string>>& sequences) {
  std::vector<std::size_t> done(sequences.size(), 0);
  std::vector<bool> differs(sequences.size(), false);
  std::size_t common = 0;
  for (const TaskAction& action : decisions) {
    const bool is_visit = action.kind == TaskActionKind::Visit || action.kind == TaskActionKind::Accompany;
    const auto agent = static_cast<std::size_t>(action.agent);
    if (!is_visit || agent >= sequences.size() || differs[agent]) continue;
    const auto& sequence = sequences[agent];
    const std::string& id = world.sources[static_cast<std::size_t>(action.source)].id;
    differs[agent] = done[agent] >= sequence.size() || sequence[done[agent]] != id;
    if (differs[agent]) continue;
    ++done[agent];
    ++common;
  }
  return common;
}

}  // namespace tandem
