#include "services/planner/core/srs/reward_account.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kEmpty = 1e-12;
constexpr int kOuterSteps = 64;  ///< of Simpson's rule outside a boundary; even

Vector2d position_at(const AgentMove& move, double share) {
  return move.from_in_map + share * (move.to_in_map - move.from_in_map);
}

/// The reward outside a boundary from share `a` to share `b` of a move that lasts `duration_s`.
double outer_reward(const RewardSource& source, const AgentMove& move, double a, double b, double duration_s) {
  double sum = rate_at(source, position_at(move, a)) + rate_at(source, position_at(move, b));
  for (int i = 1; i < kOuterSteps; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) * rate_at(source, position_at(move, a + (b - a) * i / kOuterSteps));
  }
  return sum * (b - a) * duration_s / (3.0 * kOuterSteps);
}

bool draws_on_pool(const RewardSource& source) {
  return std::isfinite(source.pool) && source.pool * source.rate_per_s > 0.0;
}

}  // namespace

struct RewardAccount::Draw {
  std::size_t source = 0;
  std::size_t agent = 0;
  double rate_per_s = 0.0;
};

RewardAccount::RewardAccount(const RewardWorld& world) : world_(world), consumed_(world.sources.size(), false) {
  assert(!problem_of(world));
  for (const auto& source : world.sources) left_.push_back(std::abs(source.pool));
}

void RewardAccount::consume(std::size_t source) {
  left_[source] = 0.0;
  consumed_[source] = true;
}

double RewardAccount::left(std::size_t source) const {
  return std::copysign(left_[source], world_.sources[source].pool);
}

bool RewardAccount::pays(std::size_t source, const std::string& agent) const {
  const RewardSource& the_source = world_.sources[source];
  if (!is_target(the_source, agent) || (draws_on_pool(the_source) && left_[source] <= kEmpty)) return false;
  for (const auto& relation : world_.relations) {
    if (relation.kind == RelationKind::Strict && relation.to == the_source.id &&
        !consumed_[*index_of(world_, relation.from)]) {
      return false;
    }
    if (relation.kind == RelationKind::Soft && relation.from == the_source.id &&
        consumed_[*index_of(world_, relation.to)] &&
        (relation.agents.empty() || std::ranges::find(relation.agents, agent) != relation.agents.end())) {
      return false;
    }
  }
  return true;
}

std::vector<double> RewardAccount::advance(const std::vector<AgentMove>& moves, double duration_s) {
  assert(duration_s >= 0.0);
  std::vector<double> rewards(moves.size(), 0.0);
  std::vector<double> shares{0.0, 1.0};
  for (const auto& source : world_.sources) {
    for (const auto& move : moves) {
      const auto more = crossings(source.boundary, move.from_in_map, move.to_in_map);
      shares.insert(shares.end(), more.begin(), more.end());
    }
  }
  std::sort(shares.begin(), shares.end());
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    if (shares[i + 1] > shares[i])
      drain(moves, duration_s, shares[i] * duration_s, shares[i + 1] * duration_s, rewards);
  }
  return rewards;
}

/// Nobody crosses a boundary between `from_s` and `to_s`; only pools that run dry change the rates.
void RewardAccount::drain(const std::vector<AgentMove>& moves, double duration_s, double from_s, double to_s,
                          std::vector<double>& rewards) {
  const double middle = 0.5 * (from_s + to_s) / duration_s;
  const std::size_t count = world_.sources.size();
  double now_s = from_s;
  while (now_s < to_s) {
    std::vector<Draw> draws;
    std::vector<double> outflow_per_s(count, 0.0);  // own draws on the pool
    for (std::size_t s = 0; s < count; ++s) {
      const RewardSource& source = world_.sources[s];
      for (std::size_t a = 0; a < moves.size(); ++a) {
        if (!pays(s, moves[a].agent)) continue;
        const bool inside = contains(source.boundary, position_at(moves[a], middle));
        if (!inside && source.outer_rate_per_s == 0.0) continue;
        draws.push_back({s, a, inside ? source.rate_per_s : 0.0});
        if (inside && draws_on_pool(source)) outflow_per_s[s] += std::abs(source.rate_per_s);
      }
    }
    std::vector<double> steady_per_s(count, 0.0);  // with what codependent sources take
    for (std::size_t s = 0; s < count; ++s) {
      if (world_.sources[s].flow == Flow::Steady) steady_per_s[s] += outflow_per_s[s];
    }
    for (const auto& relation : world_.relations) {
      if (relation.kind != RelationKind::Codependent) continue;
      const std::size_t i = *index_of(world_, relation.from);
      const std::size_t j = *index_of(world_, relation.to);
      if (world_.sources[i].flow == Flow::Steady) steady_per_s[j] += relation.coupling * outflow_per_s[i];
      if (world_.sources[j].flow == Flow::Steady) steady_per_s[i] += relation.coupling * outflow_per_s[j];
    }
    double step_s = to_s - now_s;
    for (std::size_t s = 0; s < count; ++s) {
      if (steady_per_s[s] > 0.0 && left_[s] > kEmpty) step_s = std::min(step_s, left_[s] / steady_per_s[s]);
    }
    std::vector<double> share_paid(count, 0.0);
    for (std::size_t s = 0; s < count; ++s) {
      if (world_.sources[s].flow == Flow::Proportional && outflow_per_s[s] > 0.0) {
        share_paid[s] = left_[s] * -std::expm1(-outflow_per_s[s] * step_s) / outflow_per_s[s];
      }
    }
    for (const Draw& draw : draws) {
      const RewardSource& source = world_.sources[draw.source];
      if (draw.rate_per_s == 0.0) {
        rewards[draw.agent] +=
            outer_reward(source, moves[draw.agent], now_s / duration_s, (now_s + step_s) / duration_s, duration_s);
      } else {
        rewards[draw.agent] += draw.rate_per_s * (source.flow == Flow::Proportional ? share_paid[draw.source] : step_s);
      }
    }
    for (std::size_t s = 0; s < count; ++s) {
      if (!std::isfinite(left_[s])) continue;
      left_[s] -= steady_per_s[s] * step_s + share_paid[s] * outflow_per_s[s];
      if (left_[s] <= kEmpty * std::max(1.0, std::abs(world_.sources[s].pool))) {
        left_[s] = 0.0;
        consumed_[s] = true;
      }
    }
    now_s = step_s > 0.0 ? now_s + step_s : to_s;
    if (to_s - now_s < 1e-12) break;
  }
}

}  // namespace tandem
