#include "services/planner/core/srs/reward_account.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "services/planner/core/srs/event_expectation.hpp"

namespace tandem {
namespace {

constexpr double kEmpty = 1e-12;  ///< the share of a pool below which nothing is left
constexpr std::size_t kUnwatched = DrawList::Step::kNone;

}  // namespace

RewardAccount::RewardAccount(const ResolvedWorld& world) : world_(&world), state_(initial_state(world)) {}

void RewardAccount::record_to(RewardRecord* record) {
  record_ = record;
  if (record_ != nullptr) record_->paid.resize(world_->sources().size() * world_->agent_count(), 0.0);
}

double RewardAccount::left(std::size_t source) const {
  const std::size_t pool = world_->sources()[source].pool;
  return std::copysign(state_.left[pool], world_->pools()[pool].size);
}

double RewardAccount::drawn(std::size_t source) const {
  return state_.drawn[world_->sources()[source].pool];
}

bool RewardAccount::is_consumed(std::size_t source) const {
  return state_.left[world_->sources()[source].pool] == 0.0;
}

bool RewardAccount::can_pay(std::size_t source, std::size_t agent) const {
  const ResolvedSource& one = world_->sources()[source];
  return (one.targets & mask_of(agent)) != 0 && state_.left[one.pool] > 0.0 &&
         !is_silenced(one, agent, *world_, state_);
}

bool RewardAccount::is_open(std::size_t source, std::size_t agent) const {
  const ResolvedSource& one = world_->sources()[source];
  return (one.targets & mask_of(agent)) != 0 && is_opened(one, state_) && !is_silenced(one, agent, *world_, state_);
}

void RewardAccount::consume(std::size_t source) {
  const std::size_t pool = world_->sources()[source].pool;
  const ResolvedPool& the_pool = world_->pools()[pool];
  if (state_.left[pool] == 0.0) return;
  draws_.clear();
  const double amount = std::isfinite(the_pool.size) ? state_.left[pool] : 0.0;
  state_.left[pool] = 0.0;
  if (std::isfinite(the_pool.size)) state_.drawn[pool] = std::abs(the_pool.size);
  note(RewardEvent::Kind::Consumed, pool, state_.time_s);
  for (const std::size_t gate : the_pool.gates) {
    if (state_.through[gate] == 0) note(RewardEvent::Kind::Triggered, pool, state_.time_s);
    state_.through[gate] = 1;
  }
  for (const auto& coupling : the_pool.couplings) {
    take_from_pool(coupling.pool, std::min(coupling.coupling * amount, state_.left[coupling.pool]), state_.time_s);
  }
}

void RewardAccount::advance(std::span<const AgentMove> moves, double duration_s, std::span<double> rewards) {
  run({moves, duration_s}, kUnwatched, rewards);
}

double RewardAccount::advance_until_consumed(std::size_t source, std::span<const AgentMove> moves, double duration_s,
                                             std::span<double> rewards) {
  return run({moves, duration_s}, world_->sources()[source].pool, rewards);
}

double RewardAccount::run(const JointMove& joint, std::size_t watched_pool, std::span<double> rewards) {
  assert(joint.moves.size() == world_->agent_count() && rewards.size() == joint.moves.size());
  assert(joint.duration_s >= 0.0);
  double now_s = 0.0;
  const auto is_over = [&] { return watched_pool != kUnwatched && state_.left[watched_pool] == 0.0; };
  if (joint.duration_s > 0.0 && !is_over()) {
    draws_.begin_move(*world_, state_, joint);
    const auto& shares = draws_.shares();
    for (std::size_t i = 0; i + 1 < shares.size() && !is_over(); ++i) {
      if (shares[i + 1] > shares[i]) now_s = run_part(joint, shares[i], shares[i + 1], watched_pool, rewards);
    }
  }
  state_.time_s += now_s;
  return now_s;
}

/// Gives the time of the joint move at which it ended.
double RewardAccount::run_part(const JointMove& joint, double from_share, double to_share, std::size_t watched_pool,
                               std::span<double> rewards) {
  draws_.begin_part(*world_, joint, from_share, to_share);
  double now_s = from_share * joint.duration_s;
  const double end_s = to_share * joint.duration_s;
  while (now_s < end_s) {
    draws_.begin_step(*world_, state_);
    if (open_on_entry(state_.time_s + now_s)) continue;
    const DrawList::Step step = draws_.longest_step(*world_, state_, joint, now_s, end_s);
    pay(joint, now_s, step, rewards);
    take(step, state_.time_s + now_s + step.length_s);
    if (step.ended_by == DrawList::Step::kNone) return end_s;
    now_s += step.length_s;
    if (watched_pool != kUnwatched && state_.left[watched_pool] == 0.0) return now_s;
  }
  return end_s;
}

/// Gates that wait for an entry and get one now; whether there were any.
bool RewardAccount::open_on_entry(double time_s) {
  bool opened = false;
  for (const auto& contact : draws_.contacts()) {
    if (!contact.inside || !is_open(contact.source, contact.agent)) continue;
    for (const std::size_t gate : world_->pools()[contact.pool].gates) {
      if (!world_->gates()[gate].on_entry || state_.through[gate] != 0) continue;
      state_.through[gate] = 1;
      opened = true;
      if (record_ != nullptr) {
        record_->events.push_back({RewardEvent::Kind::Triggered, contact.source, time_s, mask_of(contact.agent)});
      }
    }
  }
  return opened;
}

void RewardAccount::pay(const JointMove& joint, double now_s, const DrawList::Step& step, std::span<double> rewards) {
  const EventExpectation expectation{*world_, state_, draws_, now_s};
  for (auto& draw : draws_.draws()) {
    const ResolvedSource& source = world_->sources()[draw.source];
    double reward = 0.0;
    if (source.flow == Flow::Proportional) {
      const double outflow_per_s = draws_.outflow_per_s(draw.pool);
      reward = state_.left[draw.pool] * -std::expm1(-outflow_per_s * step.length_s) * draw.per_s / outflow_per_s;
      draw.amount = reward;
    } else {
      reward = draws_.steady_amount(draw, *world_, joint, now_s, step.length_s);
      draw.amount = std::abs(reward);
      if (expectation.concerns(draw)) reward = expectation.expected_amount(draw, joint, step.length_s);
    }
    reward *= source.worth[draw.agent];
    rewards[draw.agent] += reward;
    if (record_ != nullptr) record_->paid[draw.source * world_->agent_count() + draw.agent] += reward;
  }
}

/// Takes from the pools what was drawn from them in the step.
void RewardAccount::take(const DrawList::Step& step, double time_s) {
  for (const std::size_t pool : draws_.pools()) {
    double amount = 0.0;
    for (const auto& draw : draws_.draws()) {
      if (draw.takes && draw.pool == pool) amount += draw.amount;
      if (!draw.takes) continue;
      for (const auto& coupling : world_->pools()[draw.pool].couplings) {
        if (coupling.pool == pool) amount += coupling.coupling * draw.amount;
      }
    }
    for (const std::size_t event : world_->pools()[pool].feeds) state_.drawn[event] += amount;
    take_from_pool(pool, pool == step.ended_by ? step.amount : amount, time_s);
  }
}

void RewardAccount::take_from_pool(std::size_t pool, double amount, double time_s) {
  const double size = std::abs(world_->pools()[pool].size);
  const bool was_empty = state_.left[pool] == 0.0;
  state_.drawn[pool] += amount;
  if (std::isfinite(size) && !was_empty) {
    state_.left[pool] -= amount;
    if (state_.left[pool] <= kEmpty * size) {
      state_.left[pool] = 0.0;
      state_.drawn[pool] = size;
      note(RewardEvent::Kind::Exhausted, pool, time_s);
    }
  }
  pass_gates(pool, time_s);
}

void RewardAccount::pass_gates(std::size_t pool, double time_s) {
  for (const std::size_t gate : world_->pools()[pool].gates) {
    const double amount = world_->gates()[gate].amount;
    if (state_.through[gate] != 0 || state_.drawn[pool] < amount * (1.0 - kEmpty)) continue;
    state_.through[gate] = 1;
    note(RewardEvent::Kind::Triggered, pool, time_s);
  }
}

void RewardAccount::note(RewardEvent::Kind kind, std::size_t pool, double time_s) {
  if (record_ == nullptr) return;
  RewardEvent event{kind, world_->pools()[pool].sources.front(), time_s, 0};
  for (const auto& draw : draws_.draws()) {
    if (draw.pool == pool && draw.takes) event.agents |= mask_of(draw.agent);
  }
  record_->events.push_back(event);
}

}  // namespace tandem
