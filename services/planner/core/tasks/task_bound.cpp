#include "services/planner/core/tasks/task_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "services/planner/core/tasks/stations.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kNever_s = 1e18;
constexpr double kSlack = 1e-9;          ///< of sums in floating point
constexpr double kShareOfSpeed = 0.98;   ///< rounding to milliseconds may slow a walk down a little

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

}  // namespace

TaskBound::TaskBound(const TaskModel& model) : model_(model) {
  const ResolvedWorld& world = model.world();
  const std::size_t agents = model.agent_count();
  const std::size_t count = world.sources().size();
  walking_cost_per_s_ = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < agents; ++a) {
    top_speed_mps_ = std::max(top_speed_mps_, model.problem().agents[a].searcher.speed_mps);
    walking_cost_per_s_ = std::min(walking_cost_per_s_, model.cost_of_walking_per_s(a));
  }
  shape_.resize(count);
  peak_.assign(count * agents, 0.0);
  bool may_walk_slowly = false;
  for (std::size_t s = 0; s < count; ++s) {
    const ResolvedSource& source = world.sources()[s];
    shape_[s] = footprint(source);
    may_walk_slowly |= is_moving(source.boundary);
    for (std::size_t a = 0; a < agents; ++a) {
      if ((source.targets & mask_of(a)) == 0) continue;
      peak_[s * agents + a] = std::max({0.0, peak_of(source.inside), peak_of(source.outside)}) * source.pace[a];
    }
  }
  if (may_walk_slowly) walking_cost_per_s_ = 0.0;
  gap_m_.assign(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const auto disc = shape_[j] ? enclosing_disc(*shape_[j]) : std::nullopt;
      if (i != j && shape_[i] && disc) gap_m_[i][j] = std::max(0.0, distance_m(i, disc->centre) - disc->radius_m);
    }
  }
  const auto pays = [&](std::size_t s) {
    return std::any_of(peak_.begin() + static_cast<std::ptrdiff_t>(s * agents),
                       peak_.begin() + static_cast<std::ptrdiff_t>((s + 1) * agents), [](double p) { return p > 0.0; });
  };
  for (const ResolvedPool& pool : world.pools()) {
    bool apart = pool.sources.size() == 1 && shape_[pool.sources[0]].has_value() && pool.flow == Flow::Steady;
    for (std::size_t other = 0; apart && other < count; ++other) {
      const std::size_t own = pool.sources[0];
      if (other == own || !pays(other)) continue;
      apart = std::max(gap_m_[own][other], gap_m_[other][own]) > 0.0;
    }
    is_apart_.push_back(apart);
  }
  std::vector<bool> is_taken(world.pools().size(), false);
  const auto are_twins = [&](std::size_t i, std::size_t j) {
    return std::ranges::any_of(world.pools()[i].couplings,
                               [&](const auto& coupling) { return coupling.pool == j && coupling.coupling >= 1.0; });
  };
  for (std::size_t i = 0; i < world.pools().size(); ++i) {
    if (is_taken[i]) continue;
    auto& twins = twins_.emplace_back();
    for (std::size_t j = i; j < world.pools().size(); ++j) {
      if (is_taken[j] || !std::ranges::all_of(twins, [&](std::size_t k) { return are_twins(k, j); })) continue;
      is_taken[j] = true;
      twins.push_back(j);
    }
  }
}

double TaskBound::distance_m(std::size_t source, const Vector2d& point) const {
  return shape_[source] ? std::max(0.0, signed_distance(*shape_[source], point)) : 0.0;
}

/// How soon each agent can be in each source, from where it is and what it is doing.
void TaskBound::find_reaches(const TaskState& state) {
  const std::size_t agents = model_.agent_count();
  const std::size_t count = model_.world().sources().size();
  const double now_s = static_cast<double>(state.now_ms) * 1e-3;
  hopeful_.assign(count * agents, false);
  reach_s_.assign(count * agents, kNever_s);
  rest_distance_m_.assign(count, std::numeric_limits<double>::infinity());
  for (std::size_t a = 0; a < agents; ++a) {
    const TaskAgentState& one = state.agents[a];
    const double speed_mps = model_.problem().agents[a].searcher.speed_mps;
    const bool is_still = one.occupation == Occupation::Done;
    const bool is_walking = one.leg != nullptr && state.now_ms < one.arrival_ms() && !is_still;
    for (std::size_t s = 0; s < count; ++s) {
      if (peak_[s * agents + a] <= 0.0 || !model_.is_hopeful(state, s, a)) continue;
      hopeful_[s * agents + a] = true;
      const double here_m = distance_m(s, one.point_in_map);
      double reach_s = is_still && here_m > 0.0 ? kNever_s : now_s + here_m / speed_mps;
      if (is_walking && here_m > 0.0) {
        const auto& points = one.leg->points;
        const Vector2d& end = points.back().point_in_map;
        const double end_m = distance_m(s, end);
        const double arrival_s = static_cast<double>(one.arrival_ms()) * 1e-3;
        bool is_passed = false;
        for (std::size_t i = 1; shape_[s] && i < points.size() && !is_passed; ++i) {
          const Vector2d& from = points[i - 1].point_in_map;
          const Vector2d& to = points[i].point_in_map;
          const auto disc = enclosing_disc(*shape_[s]);
          if (!disc) {
            is_passed = true;
            break;
          }
          const double length2 = (to - from).squaredNorm();
          const double share =
              length2 > 0.0 ? std::clamp((disc->centre - from).dot(to - from) / length2, 0.0, 1.0) : 0.0;
          is_passed = (from + share * (to - from) - disc->centre).norm() <= disc->radius_m + kSlack;
        }
        const bool goes_on = one.occupation != Occupation::GoingToGoal;
        if (!is_passed) reach_s = goes_on || end_m <= 0.0 ? arrival_s + end_m / speed_mps : kNever_s;
        rest_distance_m_[s] = std::min(rest_distance_m_[s], is_passed ? 0.0 : end_m);
      } else if (!is_still || here_m <= 0.0) {
        rest_distance_m_[s] = std::min(rest_distance_m_[s], here_m);
      }
      reach_s_[s * agents + a] = reach_s;
    }
  }
}

/// The earliest time at which all strict predecessors of the source can be consumed.
double TaskBound::opening_s(const TaskState& state, std::size_t source) {
  if (opening_s_[source] >= 0.0) return opening_s_[source];
  const ResolvedWorld& world = model_.world();
  const std::size_t agents = model_.agent_count();
  double opening = 0.0;
  for (const std::size_t g : world.sources()[source].opened_by) {
    if (state.rewards.through[g] != 0) continue;
    const ResolvedGate& gate = world.gates()[g];
    const ResolvedPool& pool = world.pools()[gate.pool];
    if (pool.is_event) continue;
    const bool is_coupled = !pool.couplings.empty();
    const double missing = gate.on_entry || is_coupled || pool.flow != Flow::Steady
                               ? 0.0
                               : std::max(0.0, gate.amount - state.rewards.drawn[gate.pool]);
    double earliest = is_coupled ? 0.0 : kNever_s;
    double flow_per_s = 0.0;
    for (const std::size_t before : pool.sources) {
      const double before_opens = opening_s(state, before);
      for (std::size_t a = 0; a < agents; ++a) {
        const std::size_t key = before * agents + a;
        if (!hopeful_[key]) continue;
        earliest = std::min(earliest, std::max(before_opens, reach_s_[key]));
        flow_per_s += peak_[key];
      }
    }
    opening = std::max(opening, missing > 0.0 && flow_per_s > 0.0 ? earliest + missing / flow_per_s : earliest);
  }
  return opening_s_[source] = opening;
}

/// How long somebody has to walk at least, outside all other sources, to get into this one.
double TaskBound::entry_s(std::size_t source) const {
  const std::size_t agents = model_.agent_count();
  double least_m = rest_distance_m_[source];
  for (std::size_t other = 0; other < gap_m_.size(); ++other) {
    bool is_hopeful = false;
    for (std::size_t a = 0; a < agents; ++a) is_hopeful |= hopeful_[other * agents + a];
    if (other != source && is_hopeful) least_m = std::min(least_m, std::max(gap_m_[source][other], gap_m_[other][source]));
  }
  return std::isfinite(least_m) ? kShareOfSpeed * least_m / top_speed_mps_ : 0.0;
}

TaskBound::Item TaskBound::item_of(const TaskState& state, std::size_t pool_index) {
  const ResolvedWorld& world = model_.world();
  const ResolvedPool& pool = world.pools()[pool_index];
  const std::size_t agents = model_.agent_count();
  Item item;
  double most_worth = 0.0;
  double fastest_per_s = 0.0;
  double drawing_s = 0.0;
  for (std::size_t a = 0; a < agents; ++a) {
    double best = 0.0;  // of a group, one draws from the strongest only
    double time_s = 0.0;
    for (const std::size_t s : pool.sources) {
      const std::size_t key = s * agents + a;
      if (!hopeful_[key]) continue;
      const double from_s = std::max(reach_s_[key], opening_s(state, s));
      const double limit_s = static_cast<double>(model_.limit_ms(a)) * 1e-3;
      // Who stays where it is goes on drawing after its own limit.
      const bool may_stay = distance_m(s, state.agents[a].point_in_map) <= 0.0 || reach_s_[key] < limit_s;
      const double end_s = may_stay ? static_cast<double>(model_.horizon_ms()) * 1e-3 : limit_s;
      const double span_s = std::max(0.0, end_s - from_s);
      const double worth = world.sources()[s].worth[a];
      if (span_s <= 0.0) continue;
      const double per_s = pool.flow == Flow::Proportional ? peak_[key] * state.rewards.left[pool_index] : peak_[key];
      best = std::max(best, per_s * worth * span_s);
      time_s = std::max(time_s, span_s);
      most_worth = std::max(most_worth, worth);
      fastest_per_s = std::max(fastest_per_s, peak_[key]);
    }
    item.value += best;
    drawing_s += time_s;
  }
  if (item.value <= 0.0) return {};
  const double left = state.rewards.left[pool_index];
  if (!is_apart_[pool_index]) {
    item.value = std::min(item.value, left * most_worth);
    return item;
  }
  const double entry = entry_s(pool.sources[0]);
  if (left * most_worth <= item.value) {
    item.value = left * most_worth;
    drawing_s = pool.couplings.empty() ? std::min(drawing_s, left / fastest_per_s) : 0.0;
  }
  item.value = std::max(0.0, item.value - walking_cost_per_s_ * entry);
  item.time_s = pool.couplings.empty() ? drawing_s + entry : entry;
  return item;
}

/// What the ways that agents are on cost them for sure.
double TaskBound::settled_cost(const TaskState& state) const {
  double cost = 0.0;
  for (std::size_t a = 0; a < model_.agent_count(); ++a) {
    const TaskAgentState& one = state.agents[a];
    if (one.leg == nullptr || one.occupation == Occupation::Done || one.occupation == Occupation::Committed) continue;
    const auto& points = one.leg->points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const std::int64_t from_ms = std::max(state.now_ms, one.leg_start_ms + points[i - 1].time_ms);
      const std::int64_t to_ms = std::min(model_.horizon_ms(), one.leg_start_ms + points[i].time_ms);
      if (to_ms <= from_ms || points[i].point_in_map == points[i - 1].point_in_map) continue;
      cost += kShareOfSpeed * model_.cost_of_walking_per_s(a) * static_cast<double>(to_ms - from_ms) * 1e-3;
    }
  }
  return cost;
}

double TaskBound::operator()(const TaskState& state) {
  if (model_.decider(state) == TaskModel::kNobody) return state.value;
  const ResolvedWorld& world = model_.world();
  find_reaches(state);
  opening_s_.assign(world.sources().size(), -1.0);
  items_.clear();
  for (const auto& twins : twins_) {
    Item sum;
    double most = 0.0;
    for (const std::size_t pool : twins) {
      const Item item = item_of(state, pool);
      if (twins.size() == 1) {
        sum = item;
        most = item.value;
      } else {
        sum.value += item.value;
        double worth = 0.0;
        for (const std::size_t s : world.pools()[pool].sources) {
          worth = std::max(worth, *std::ranges::max_element(world.sources()[s].worth));
        }
        for (const std::size_t other : twins) most = std::max(most, worth * state.rewards.left[other]);
      }
    }
    sum.value = std::min(sum.value, most);
    if (sum.value > 0.0) items_.push_back(sum);
  }
  double team_s = 0.0;
  for (std::size_t a = 0; a < model_.agent_count(); ++a) {
    team_s += std::max<double>(0.0, static_cast<double>(model_.horizon_ms() - state.now_ms) * 1e-3);
  }
  std::ranges::sort(items_, [](const Item& a, const Item& b) { return a.value * b.time_s > b.value * a.time_s; });
  double bound = state.value - settled_cost(state);
  for (const Item& item : items_) {
    const double share = item.time_s > team_s ? team_s / item.time_s : 1.0;
    bound += share * item.value;
    team_s -= share * item.time_s;
  }
  return bound + kSlack * std::max(1.0, std::abs(bound));
}

}  // namespace tandem
