#include "services/planner/core/srs/resolved_world.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tandem {

ResolvedWorld::ResolvedWorld(RewardWorld world) : world_(std::move(world)) {
  assert(!problem_of(world_));
  resolve_sources();
  resolve_pools();
  resolve_relations();
}

void ResolvedWorld::resolve_sources() {
  for (const auto& source : world_.sources) {
    ResolvedSource one;
    one.boundary = resolved(source.boundary, world_.agents);
    if (source.outside == RewardRatio{}) {
      if (const auto shape = shape_in_map(source.boundary)) one.reach = enclosing_disc(*shape);
    }
    one.inside = source.inside;
    one.outside = source.outside;
    one.kind = source.kind;
    one.flow = source.flow;
    one.pace.assign(world_.agents.size(), 1.0);
    one.worth.assign(world_.agents.size(), 1.0);
    for (const auto& temper : source.tempers) {
      const std::size_t agent = *agent_index_of(world_, temper.agent);
      one.pace[agent] = temper.pace;
      one.worth[agent] = temper.worth;
    }
    for (std::size_t agent = 0; agent < world_.agents.size(); ++agent) {
      if (is_target(source, world_.agents[agent])) one.targets |= mask_of(agent);
    }
    sources_.push_back(std::move(one));
  }
}

void ResolvedWorld::resolve_pools() {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SourceGroup* group = group_of(world_, world_.sources[i].id);
    if (group != nullptr) {
      const auto known = std::ranges::find_if(group->members,
                                              [&](const std::string& member) { return *index_of(world_, member) < i; });
      if (known != group->members.end()) {
        sources_[i].pool = sources_[*index_of(world_, *known)].pool;
        pools_[sources_[i].pool].sources.push_back(i);
        continue;
      }
    }
    ResolvedPool pool;
    pool.size = group != nullptr ? group->pool : world_.sources[i].pool;
    pool.flow = sources_[i].flow;
    pool.sources = {i};
    pool.is_event = std::holds_alternative<Nowhere>(sources_[i].boundary);
    sources_[i].pool = pools_.size();
    pools_.push_back(std::move(pool));
  }
}

void ResolvedWorld::resolve_relations() {
  for (std::size_t r = 0; r < world_.relations.size(); ++r) {
    const Relation& relation = world_.relations[r];
    const std::size_t from = *index_of(world_, relation.from);
    const std::size_t to = *index_of(world_, relation.to);
    const std::size_t from_pool = sources_[from].pool;
    const std::size_t to_pool = sources_[to].pool;
    if (relation.kind == RelationKind::Codependent) {
      pools_[from_pool].couplings.push_back({to_pool, relation.coupling});
      pools_[to_pool].couplings.push_back({from_pool, relation.coupling});
      continue;
    }
    const bool strict = relation.kind == RelationKind::Strict;
    ResolvedGate gate;
    gate.pool = strict ? from_pool : to_pool;
    gate.relation = r;
    gate.on_entry = relation.trigger.kind == Trigger::Kind::Entry;
    gate.amount = std::numeric_limits<double>::infinity();
    if (relation.trigger.kind == Trigger::Kind::Fraction) {
      gate.amount = relation.trigger.value * std::abs(pools_[gate.pool].size);
    } else if (relation.trigger.kind == Trigger::Kind::Amount) {
      gate.amount = relation.trigger.value;
    }
    for (std::size_t agent = 0; agent < world_.agents.size(); ++agent) {
      if (relation.agents.empty() || std::ranges::count(relation.agents, world_.agents[agent]) > 0) {
        gate.agents |= mask_of(agent);
      }
    }
    pools_[gate.pool].gates.push_back(gates_.size());
    (strict ? sources_[to].opened_by : sources_[from].silenced_by).push_back(gates_.size());
    if (!strict && pools_[to_pool].is_event) {
      if (sources_[from].flow == Flow::Proportional) {
        pools_[from_pool].feeds.push_back(to_pool);
      } else {
        sources_[from].expected_by.push_back(gates_.size());
      }
    }
    gates_.push_back(gate);
  }
}

double rate_of(const ResolvedSource& source, std::size_t agent, const JointMove& joint, double share) {
  if ((source.targets & mask_of(agent)) == 0 || !is_somewhere(source.boundary, joint)) return 0.0;
  const BoundaryVector vector = vector_to(source.boundary, agent, joint, share);
  const RewardRatio& ratio = vector.distance <= kOnBoundary_m ? source.inside : source.outside;
  return ratio_at(ratio, vector) * source.pace[agent] * source.worth[agent];
}

double peak_rate_of(const ResolvedSource& source, std::size_t agent) {
  if ((source.targets & mask_of(agent)) == 0) return 0.0;
  const double inside = peak_of(source.inside);
  const double outside = peak_of(source.outside);
  return (std::abs(inside) >= std::abs(outside) ? inside : outside) * source.pace[agent] * source.worth[agent];
}

}  // namespace tandem
