#include "services/planner/core/tasks/task_bound.hpp"

#include <algorithm>
#include <cmath>

#include "services/planner/core/tasks/stations.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kNever_s = 1e18;
constexpr double kSlack = 1e-9;         ///< of sums in floating point
constexpr double kShareOfSpeed = 0.98;  ///< rounding to milliseconds may slow a walk down a little

/// The shape on the ground outside which the source pays nothing; none if it may pay anywhere.
std::optional<PlanarShape> footprint(const ResolvedSource& source) {
  if (peak_of(source.outside) > 0.0) return std::nullopt;
  if (const auto* placed = std::get_if<PlacedShape>(&source.boundary); placed != nullptr && placed->owner < 0) {
    return placed->shape;
  }
  if (const auto* sphere = std::get_if<Sphere>(&source.boundary)) {
    return Disc{sphere->centre_in_map.head<2>(), sphere->radius_m};
  }
  if (const auto* box = std::get_if<Box>(&source.boundary)) {
    const Vector2d low = box->low_in_map.head<2>();
    const Vector2d high = box->high_in_map.head<2>();
    return Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
  }
  return std::nullopt;
}

double seconds(std::int64_t time_ms) {
  return static_cast<double>(time_ms) * 1e-3;
}

}  // namespace

TaskBound::TaskBound(const TaskModel& model) : model_(model), agents_(model.agent_count()) {
  find_footprints();
  find_gaps();
  find_twins();
  time_left_s_.assign(agents_, 0.0);
  groups_.resize(twins_.size());
}

void TaskBound::find_footprints() {
  for (const ResolvedSource& source : model_.world().sources()) {
    shape_.push_back(footprint(source));
    disc_.push_back(shape_.back() ? enclosing_disc(*shape_.back()) : std::nullopt);
    may_walk_slowly_ |= is_moving(source.boundary);
    const double peak = std::max({0.0, peak_of(source.inside), peak_of(source.outside)});
    for (std::size_t a = 0; a < agents_; ++a) {
      peak_.push_back((source.targets & mask_of(a)) != 0 ? peak * source.pace[a] : 0.0);
    }
  }
}

void TaskBound::find_gaps() {
  const ResolvedWorld& world = model_.world();
  const std::size_t count = world.sources().size();
  gap_m_.assign(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j || !shape_[i] || !disc_[j]) continue;
      const double gap_m = std::max(0.0, distance_m(i, disc_[j]->centre) - disc_[j]->radius_m);
      gap_m_[i][j] = gap_m_[j][i] = std::max(gap_m_[j][i], gap_m);
    }
  }
  const auto pays = [&](std::size_t s) {
    return std::any_of(peak_.begin() + static_cast<std::ptrdiff_t>(s * agents_),
                       peak_.begin() + static_cast<std::ptrdiff_t>((s + 1) * agents_),
                       [](double p) { return p > 0.0; });
  };
  for (const ResolvedPool& pool : world.pools()) {
    bool apart = pool.sources.size() == 1 && shape_[pool.sources[0]].has_value() && pool.flow == Flow::Steady;
    for (std::size_t other = 0; apart && other < count; ++other) {
      apart = other == pool.sources[0] || !pays(other) || gap_m_[pool.sources[0]][other] > 0.0;
    }
    is_apart_.push_back(apart);
  }
}

void TaskBound::find_twins() {
  const ResolvedWorld& world = model_.world();
  const auto are_twins = [&](std::size_t i, std::size_t j) {
    return std::ranges::any_of(world.pools()[i].couplings,
                               [&](const auto& coupling) { return coupling.pool == j && coupling.coupling >= 1.0; });
  };
  std::vector<bool> is_taken(world.pools().size(), false);
  for (std::size_t i = 0; i < world.pools().size(); ++i) {
    if (is_taken[i]) continue;
    auto& pools = twins_.emplace_back();
    for (std::size_t j = i; j < world.pools().size(); ++j) {
      if (is_taken[j] || !std::ranges::all_of(pools, [&](std::size_t k) { return are_twins(k, j); })) continue;
      is_taken[j] = true;
      pools.push_back(j);
    }
  }
}

double TaskBound::distance_m(std::size_t source, const Vector2d& point) const {
  return shape_[source] ? std::max(0.0, signed_distance(*shape_[source], point)) : 0.0;
}

bool TaskBound::may_pass(const TaskLeg& leg, std::size_t source) const {
  const auto& disc = disc_[source];
  if (!disc) return true;
  for (std::size_t i = 1; i < leg.points.size(); ++i) {
    const Vector2d& from = leg.points[i - 1].point_in_map;
    const Vector2d way = leg.points[i].point_in_map - from;
    const double length2 = way.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((disc->centre - from).dot(way) / length2, 0.0, 1.0) : 0.0;
    if ((from + share * way - disc->centre).norm() <= disc->radius_m + kSlack) return true;
  }
  return false;
}

/// How soon each agent can be in each source, from where it is and what it is doing.
void TaskBound::find_reaches(const TaskState& state) {
  const std::size_t count = shape_.size();
  const double now_s = seconds(state.now_ms);
  hopeful_.assign(count * agents_, 0);
  reach_s_.assign(count * agents_, kNever_s);
  rest_distance_m_.assign(count * agents_, std::numeric_limits<double>::infinity());
  for (std::size_t a = 0; a < agents_; ++a) {
    const TaskAgentState& one = state.agents[a];
    const double speed_mps = model_.problem().agents[a].searcher.speed_mps;
    const bool is_still = one.occupation == Occupation::Done;
    const bool is_walking = one.leg != nullptr && state.now_ms < one.arrival_ms() && !is_still;
    time_left_s_[a] = seconds((is_still ? model_.horizon_ms() : model_.limit_ms(a)) - state.now_ms);
    for (std::size_t s = 0; s < count; ++s) {
      const std::size_t key = s * agents_ + a;
      if (peak_[key] <= 0.0 || !model_.is_hopeful(state, s, a)) continue;
      hopeful_[key] = 1;
      const double here_m = distance_m(s, one.point_in_map);
      if (here_m <= 0.0 || !is_walking) {
        if (is_still && here_m > 0.0) continue;
        reach_s_[key] = now_s + here_m / speed_mps;
        rest_distance_m_[key] = here_m;
      } else if (may_pass(*one.leg, s)) {
        reach_s_[key] = now_s + here_m / speed_mps;
        rest_distance_m_[key] = 0.0;
      } else if (one.occupation != Occupation::GoingToGoal) {
        const double end_m = distance_m(s, one.leg->points.back().point_in_map);
        reach_s_[key] = seconds(one.arrival_ms()) + end_m / speed_mps;
        rest_distance_m_[key] = end_m;
      }
    }
  }
}

/// The earliest time at which all strict predecessors of the source can be consumed.
double TaskBound::opening_s(const TaskState& state, std::size_t source) {
  if (opening_s_[source] >= 0.0) return opening_s_[source];
  const ResolvedWorld& world = model_.world();
  double opening = 0.0;
  for (const std::size_t g : world.sources()[source].opened_by) {
    if (state.rewards.through[g] != 0) continue;
    const ResolvedGate& gate = world.gates()[g];
    const ResolvedPool& pool = world.pools()[gate.pool];
    // A codependent source may drain it from anywhere.
    if (pool.is_event || !pool.couplings.empty()) continue;
    const double missing =
        gate.on_entry || pool.flow != Flow::Steady ? 0.0 : std::max(0.0, gate.amount - state.rewards.drawn[gate.pool]);
    double earliest = kNever_s;
    double flow_per_s = 0.0;
    for (const std::size_t before : pool.sources) {
      const double before_opens = opening_s(state, before);
      for (std::size_t a = 0; a < agents_; ++a) {
        const std::size_t key = before * agents_ + a;
        if (hopeful_[key] == 0) continue;
        earliest = std::min(earliest, std::max(before_opens, reach_s_[key]));
        flow_per_s += peak_[key];
      }
    }
    opening = std::max(opening, missing > 0.0 && flow_per_s > 0.0 ? earliest + missing / flow_per_s : earliest);
  }
  return opening_s_[source] = opening;
}

/// For how long the agent can be in the source while it pays, at most.
double TaskBound::span_s(const TaskState& state, std::size_t source, std::size_t agent) {
  const std::size_t key = source * agents_ + agent;
  if (hopeful_[key] == 0) return 0.0;
  const double from_s = std::max(reach_s_[key], opening_s(state, source));
  // Who stays there goes on drawing when its own time is up.
  return reach_s_[key] <= seconds(model_.limit_ms(agent)) ? std::max(0.0, seconds(model_.horizon_ms()) - from_s) : 0.0;
}

/// How far the agent has to walk at least, outside all other sources that pay it, to get into this one.
double TaskBound::entry_m(std::size_t source, std::size_t agent) const {
  double least_m = rest_distance_m_[source * agents_ + agent];
  for (std::size_t other = 0; other < gap_m_.size(); ++other) {
    if (other != source && hopeful_[other * agents_ + agent] != 0) least_m = std::min(least_m, gap_m_[source][other]);
  }
  return std::isfinite(least_m) ? kShareOfSpeed * least_m : 0.0;
}

double TaskBound::value_without_time(const TaskState& state, std::size_t pool_index) {
  const ResolvedWorld& world = model_.world();
  const ResolvedPool& pool = world.pools()[pool_index];
  const double left = state.rewards.left[pool_index];
  double value = 0.0;
  double most_worth = 0.0;
  for (std::size_t a = 0; a < agents_; ++a) {
    double best = 0.0;  // of a group, one draws from the strongest only
    for (const std::size_t s : pool.sources) {
      const double time_s = span_s(state, s, a);
      if (time_s <= 0.0) continue;
      const double per_s = peak_[s * agents_ + a] * (pool.flow == Flow::Proportional ? left : 1.0);
      const double worth = world.sources()[s].worth[a];
      best = std::max(best, per_s * worth * time_s);
      most_worth = std::max(most_worth, worth);
    }
    value += best;
  }
  return value > 0.0 ? std::min(value, left * most_worth) : 0.0;
}

void TaskBound::add_item(const TaskState& state, std::size_t pool_index, std::vector<PoolItem>& items) {
  const std::size_t s = model_.world().pools()[pool_index].sources[0];
  const ResolvedSource& source = model_.world().sources()[s];
  const double left = state.rewards.left[pool_index];
  PoolItem item;
  item.is_limited = std::isfinite(left);
  bool is_worth_it = false;
  for (std::size_t a = 0; a < agents_; ++a) {
    PoolOffer& offer = item.offers[a];
    const double time_s = span_s(state, s, a);
    if (time_s <= 0.0) continue;
    const double per_s = peak_[s * agents_ + a];
    const double entry = entry_m(s, a) / model_.problem().agents[a].searcher.speed_mps;
    const double cost_per_s = may_walk_slowly_ ? 0.0 : model_.cost_of_walking_per_s(a);
    const double all_s = item.is_limited ? left / per_s : time_s;
    offer.share = std::min(1.0, time_s / all_s);
    // Who draws a part only has to walk there all the same.
    offer.time_s = all_s + entry / offer.share;
    offer.value = all_s * per_s * source.worth[a] - cost_per_s * entry / offer.share;
    is_worth_it |= offer.value > 0.0;
  }
  if (is_worth_it) items.push_back(item);
}

/// What the ways that agents are on cost them for sure.
double TaskBound::settled_cost(const TaskState& state) const {
  double cost = 0.0;
  for (std::size_t a = 0; a < agents_; ++a) {
    const TaskAgentState& one = state.agents[a];
    if (one.leg == nullptr || one.occupation == Occupation::Done || one.occupation == Occupation::Committed) continue;
    const auto& points = one.leg->points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const std::int64_t from_ms = std::max(state.now_ms, one.leg_start_ms + points[i - 1].time_ms);
      const std::int64_t to_ms = std::min(model_.horizon_ms(), one.leg_start_ms + points[i].time_ms);
      if (to_ms <= from_ms || points[i].point_in_map == points[i - 1].point_in_map) continue;
      cost += kShareOfSpeed * model_.cost_of_walking_per_s(a) * seconds(to_ms - from_ms);
    }
  }
  return cost;
}

double TaskBound::operator()(const TaskState& state, double enough) {
  if (model_.decider(state) == TaskModel::kNobody) return state.value;
  const ResolvedWorld& world = model_.world();
  find_reaches(state);
  opening_s_.assign(shape_.size(), -1.0);
  double bound = state.value - settled_cost(state);
  for (std::size_t t = 0; t < twins_.size(); ++t) {
    PoolItems& group = groups_[t];
    group.items.clear();
    double worth = 0.0;
    double fullest = 0.0;
    double without_time = 0.0;
    for (const std::size_t pool : twins_[t]) {
      if (state.rewards.left[pool] <= 0.0 || world.pools()[pool].is_event) continue;
      for (const std::size_t s : world.pools()[pool].sources) {
        worth = std::max(worth, *std::ranges::max_element(world.sources()[s].worth));
      }
      fullest = std::max(fullest, state.rewards.left[pool]);
      if (is_apart_[pool]) {
        add_item(state, pool, group.items);
      } else {
        without_time += value_without_time(state, pool);
      }
    }
    const double most = worth > 0.0 ? worth * fullest : 0.0;
    without_time = std::min(without_time, most);
    bound += without_time;
    group.most = most > without_time ? most - without_time : 0.0;
  }
  const double slack = kSlack * std::max(1.0, std::abs(enough));
  bound += assigned_(groups_, time_left_s_, enough - bound - slack);
  return bound + kSlack * std::max(1.0, std::abs(bound));
}

}  // namespace tandem
