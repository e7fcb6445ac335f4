#include "services/planner/core/tasks/task_model.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "services/planner/core/tasks/stations.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kStandReach_m = 0.5;  ///< how far from a start its nearest standpoint may be
constexpr double kSameSpot_m = 1e-6;
constexpr std::size_t kMaxSubsetsOf = 4;  ///< so many messages are tried in all combinations

/// Rounded up to whole milliseconds, but for what is only rounding of the computation.
std::int64_t in_ms(double time_s) {
  return static_cast<std::int64_t>(std::ceil(time_s * 1000.0 - 1e-6));
}

MotionOptions body_of(const Searcher& searcher) {
  MotionOptions options;
  options.radius_m = searcher.radius_m;
  options.preferred_clearance_m = searcher.preferred_clearance_m;
  return options;
}

/// What walking surely costs: the unlimited negative sources in the space of speeds at the agent's speed.
double walking_cost_per_s(const ResolvedWorld& world, std::size_t agent, double speed_mps) {
  std::vector<AgentMove> moves(world.agent_count(), absent());
  moves[agent] = straight_move(Vector2d::Zero(), {speed_mps, 0.0});
  double cost = 0.0;
  for (const ResolvedSource& source : world.sources()) {
    if (!std::holds_alternative<SpeedInterval>(source.boundary) || std::isfinite(world.pools()[source.pool].size))
      continue;
    if (!source.opened_by.empty() || !source.silenced_by.empty()) continue;
    cost -= std::min(0.0, rate_of(source, agent, {moves, 1.0}, 0.5));
  }
  return cost;
}

}  // namespace

std::optional<std::string> problem_of(const TaskProblem& problem) {
  if (const auto wrong = problem_of(problem.world)) return wrong->where + ": " + wrong->what;
  if (problem.agents.size() > kMaxTaskAgents) return "a task is for at most eight agents";
  if (problem.world.sources.size() > kMaxTaskSources) return "a task has at most 256 sources";
  if (problem.agents.size() != problem.world.agents.size()) return "the agents are not those of the world";
  for (std::size_t a = 0; a < problem.agents.size(); ++a) {
    const TaskAgent& agent = problem.agents[a];
    if (agent.searcher.id != problem.world.agents[a]) return "agent " + agent.searcher.id + " is not in its place";
    if (!problem.layers.empty() && static_cast<std::size_t>(agent.searcher.layer) >= problem.layers.size()) {
      return "agent " + agent.searcher.id + " moves on a layer that there is not";
    }
  }
  return std::nullopt;
}

TaskModel::TaskModel(const TaskProblem& problem)
    : problem_(problem), world_(problem.world), horizon_ms_(in_ms(problem.horizon_s)), account_(world_) {
  assert(!problem_of(problem));
  const std::size_t count = problem.agents.size();
  std::map<std::tuple<int, double, double>, const MotionMap*> motion_of;  // one per capability
  for (std::size_t a = 0; a < count; ++a) {
    const TaskAgent& agent = problem.agents[a];
    limits_ms_.push_back(std::isfinite(agent.searcher.endurance_s)
                             ? std::min(horizon_ms_, in_ms(agent.searcher.endurance_s))
                             : horizon_ms_);
    cost_of_walking_per_s_.push_back(walking_cost_per_s(world_, a, agent.searcher.speed_mps));
    const MotionMap* motion = nullptr;
    if (!problem.layers.empty()) {
      const MotionOptions body = body_of(agent.searcher);
      const MotionMap*& known = motion_of[{agent.searcher.layer, body.radius_m, body.preferred_clearance_m}];
      if (known == nullptr) {
        known = &motion_maps_.emplace_back(problem.layers[static_cast<std::size_t>(agent.searcher.layer)], body);
      }
      motion = known;
    }
    const Hazards& hazards = hazards_.emplace_back(world_, a, agent.altitude_m);
    travels_.emplace_back(motion, &hazards, agent.searcher, cost_of_walking_per_s_.back());
    goal_places_.push_back(agent.goal_in_map ? travels_[a].place_at(*agent.goal_in_map, 1e9) : std::nullopt);
    auto& known = known_.emplace_back();
    for (std::size_t s = 0; s < world_.sources().size(); ++s) {
      known[s] = knows(problem.world, agent.searcher.id, problem.world.sources[s].id);
    }
  }
  gates_of_pool_.resize(world_.pools().size());
  for (std::size_t g = 0; g < world_.gates().size(); ++g) gates_of_pool_[world_.gates()[g].pool].push_back(g);
  for (const ResolvedSource& source : world_.sources()) {
    has_soft_relations_ |= !source.silenced_by.empty();
    has_moving_sources_ |= is_moving(source.boundary);
  }
  nearest_stations_.resize(count);
  find_stations();
  find_messages();
  account_.record_to(&events_);
  moves_.assign(count, absent());
  rewards_.assign(count, 0.0);
}

void TaskModel::find_stations() {
  stations_.assign(agent_count(), std::vector<std::vector<Station>>(world_.sources().size()));
  for (std::size_t a = 0; a < agent_count(); ++a) {
    const TaskAgent& agent = problem_.agents[a];
    for (std::size_t s = 0; s < world_.sources().size(); ++s) {
      const ResolvedSource& source = world_.sources()[s];
      if ((source.targets & mask_of(a)) == 0 || peak_of(source.inside) <= 0.0) continue;
      for (const auto& point : stations_of(source.boundary, agent.altitude_m, agent.start.position())) {
        const auto place = travels_[a].place_at(point, kStandReach_m);
        if (!place) continue;
        const double rate = drawn_per_s_at(a, s, travels_[a].point(*place));
        if (rate > 0.0) stations_[a][s].push_back({*place, rate});
      }
    }
  }
}

void TaskModel::find_messages() {
  std::vector<Inform> useful;
  for (const Inform& inform : possible_informs(problem_.world)) {
    const auto source = *index_of(problem_.world, inform.source);
    const auto agent = *agent_index_of(problem_.world, inform.agent);
    const ResolvedSource& told = world_.sources()[source];
    if ((told.targets & mask_of(agent)) == 0 || peak_of(told.inside) <= 0.0) continue;
    if (problem_.agents[agent].freedom == TaskFreedom::Planned) useful.push_back(inform);
  }
  messages_.push_back({});
  if (useful.size() <= kMaxSubsetsOf) {
    for (std::size_t subset = 1; subset < (std::size_t{1} << useful.size()); ++subset) {
      auto& set = messages_.emplace_back();
      for (std::size_t i = 0; i < useful.size(); ++i) {
        if ((subset >> i & 1U) != 0) set.push_back(useful[i]);
      }
    }
  } else {
    for (const Inform& one : useful) messages_.push_back({one});
    messages_.push_back(useful);
  }
  for (const auto& set : messages_) {
    auto& told = told_.emplace_back(agent_count());
    for (const Inform& inform : set) {
      told[*agent_index_of(problem_.world, inform.agent)][*index_of(problem_.world, inform.source)] = true;
    }
  }
}

TaskState TaskModel::start() {
  TaskState state;
  state.rewards = initial_state(world_);
  state.told = messages_.size() == 1 ? 0 : -1;
  for (std::size_t a = 0; a < agent_count(); ++a) {
    const TaskAgent& agent = problem_.agents[a];
    TaskAgentState& one = state.agents[a];
    one.point_in_map = agent.start.position();
    one.heading_rad = agent.start.heading;
    TaskLeg leg;
    for (const TimedPoint& point : agent.committed.points) {
      const std::int64_t time_ms = in_ms(point.time_s);
      const Vector2d from = leg.points.empty() ? agent.start.position() : leg.points.back().point_in_map;
      const bool moves = (point.point_in_map - from).norm() > kSameSpot_m;
      const double before = leg.points.empty() ? agent.start.heading : leg.points.back().to_heading_rad;
      const double heading = moves ? heading_towards(from, point.point_in_map) : before;
      if (leg.points.empty() && time_ms > 0) {
        leg.points.push_back({0, agent.start.position(), before, before});
      }
      if (!leg.points.empty() && time_ms <= leg.points.back().time_ms) continue;
      leg.points.push_back({time_ms, point.point_in_map, heading, heading});
    }
    if (leg.points.size() > 1) {
      one.occupation = Occupation::Committed;
      one.leg = kept(std::move(leg));
    } else if (agent.freedom == TaskFreedom::Fixed) {
      one.occupation = Occupation::Done;
    }
  }
  if (decider(state) == kNobody) run(state);
  return state;
}

int TaskModel::decider(const TaskState& state) const {
  if (state.told < 0) return kTeller;
  if (state.now_ms >= horizon_ms_) return kNobody;
  for (std::size_t a = 0; a < agent_count(); ++a) {
    if (state.agents[a].occupation == Occupation::Free) return static_cast<int>(a);
  }
  return kNobody;
}

std::int64_t TaskModel::least_makespan_ms(const TaskState& state) const {
  std::int64_t least = state.makespan_ms;
  for (std::size_t a = 0; a < agent_count(); ++a) {
    const TaskAgentState& one = state.agents[a];
    if (one.occupation == Occupation::Visiting || one.occupation == Occupation::GoingToGoal) {
      least = std::max(least, std::min(horizon_ms_, one.arrival_ms()));
    }
  }
  return least;
}

TaskState TaskModel::after(const TaskState& state, const TaskAction& action) {
  TaskState next = state;
  if (action.kind == TaskActionKind::Tell) {
    next.told = action.source;
    const auto count = messages_[static_cast<std::size_t>(action.source)].size();
    next.value -= problem_.world.message_cost * static_cast<double>(count);
  } else {
    begin(next, action);
  }
  if (decider(next) == kNobody) run(next);
  return next;
}

bool TaskModel::is_known(const TaskState& state, std::size_t source, std::size_t agent) const {
  return known_[agent][source] || (state.told > 0 && told_[static_cast<std::size_t>(state.told)][agent][source]);
}

bool TaskModel::is_hopeful(const TaskState& state, std::size_t source, std::size_t agent) const {
  const ResolvedSource& the_source = world_.sources()[source];
  if ((the_source.targets & mask_of(agent)) == 0 || left(state, source) <= 0.0) return false;
  if (is_silenced(the_source, agent, world_, state.rewards)) return false;
  return std::ranges::all_of(the_source.opened_by, [&](std::size_t gate) {
    if (state.rewards.through[gate] != 0) return true;
    const ResolvedPool& pool = world_.pools()[world_.gates()[gate].pool];
    if (pool.is_event) return true;
    return std::ranges::any_of(pool.sources, [&](std::size_t before) {
      for (std::size_t a = 0; a < agent_count(); ++a) {
        if (is_hopeful(state, before, a)) return true;
      }
      return false;
    });
  });
}

double TaskModel::drawn_per_s_at(std::size_t agent, std::size_t source, const Vector2d& point_in_map) const {
  std::array<AgentMove, kMaxTaskAgents> moves;
  moves.fill(absent());
  moves[agent] = stay_at(point_in_map);
  moves[agent].from_altitude_m = moves[agent].to_altitude_m = problem_.agents[agent].altitude_m;
  const ResolvedSource& the_source = world_.sources()[source];
  const double worth = the_source.worth[agent];
  return worth > 0.0 ? rate_of(the_source, agent, {{moves.data(), agent_count()}, 1.0}, 0.0) / worth : 0.0;
}

const TaskLeg* TaskModel::kept(TaskLeg leg) {
  return &legs_.emplace_back(std::move(leg));
}

const TaskLeg* TaskModel::leg(std::size_t agent, int from, int to, int way, double heading_rad) {
  const Searcher& searcher = problem_.agents[agent].searcher;
  const bool turns = !searcher.sees_all_around();
  const auto [found, is_new] = leg_of_.try_emplace({agent, from, to, way, turns ? heading_rad : 0.0}, nullptr);
  if (!is_new) return found->second;
  const auto& points = travels_[agent].ways(from, to)[static_cast<std::size_t>(way)].points_in_map;
  TaskLeg result;
  double time_s = 0.0;
  double heading = heading_rad;
  const auto add = [&](const Vector2d& point, double next_heading) {
    const std::int64_t time_ms = in_ms(time_s);
    if (time_ms <= result.points.back().time_ms) {
      result.points.back().point_in_map = point;
      return;
    }
    result.points.push_back({time_ms, point, turns ? heading : next_heading, next_heading});
  };
  result.points.push_back({0, points.front(), heading, heading});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length_m = (points[i] - points[i - 1]).norm();
    if (length_m < kSameSpot_m) continue;
    const double towards = heading_towards(points[i - 1], points[i]);
    const double turn_s = turning_time_s(searcher, heading, towards);
    const double next = heading + turn_between(heading, towards);
    if (turn_s > 0.0) {
      time_s += turn_s;
      add(points[i - 1], next);
    }
    heading = next;
    time_s += length_m / searcher.speed_mps;
    add(points[i], next);
  }
  found->second = kept(std::move(result));
  return found->second;
}

int TaskModel::place_of(std::size_t agent, const TaskAgentState& state) {
  if (state.place >= 0) return state.place;
  return travels_[agent].place_at(state.point_in_map, kStandReach_m).value_or(-1);
}

void TaskModel::record_to(RewardRecord* record) {
  record_ = record;
  if (record != nullptr) record->paid.assign(world_.sources().size() * agent_count(), 0.0);
}

}  // namespace tandem
