#include "services/planner/core/srs/reward_world.hpp"

#include <algorithm>

namespace tandem {

std::optional<std::size_t> index_of(const RewardWorld& world, const std::string& source_id) {
  const auto found = std::ranges::find(world.sources, source_id, &RewardSource::id);
  if (found == world.sources.end()) return std::nullopt;
  return static_cast<std::size_t>(found - world.sources.begin());
}

std::optional<std::size_t> agent_index_of(const RewardWorld& world, const std::string& agent) {
  const auto found = std::ranges::find(world.agents, agent);
  if (found == world.agents.end()) return std::nullopt;
  return static_cast<std::size_t>(found - world.agents.begin());
}

const SourceGroup* group_of(const RewardWorld& world, const std::string& source_id) {
  for (const auto& group : world.groups) {
    if (std::ranges::count(group.members, source_id) > 0) return &group;
  }
  return nullptr;
}

std::optional<WorldProblem> add_source(RewardWorld& world, const RewardSource& source) {
  world.sources.push_back(source);
  const auto problem = problem_of(world);
  if (problem) {
    world.sources.pop_back();
  } else {
    ++world.version;
  }
  return problem;
}

std::optional<WorldProblem> add_relation(RewardWorld& world, const Relation& relation) {
  world.relations.push_back(relation);
  const auto problem = problem_of(world);
  if (problem) {
    world.relations.pop_back();
  } else {
    ++world.version;
  }
  return problem;
}

bool remove_source(RewardWorld& world, const std::string& source_id) {
  const auto index = index_of(world, source_id);
  if (!index) return false;
  world.sources.erase(world.sources.begin() + static_cast<std::ptrdiff_t>(*index));
  std::erase_if(world.relations,
                [&](const Relation& relation) { return relation.from == source_id || relation.to == source_id; });
  for (auto& group : world.groups) std::erase(group.members, source_id);
  std::erase_if(world.groups, [](const SourceGroup& group) { return group.members.empty(); });
  for (auto& unaware : world.unawareness) std::erase(unaware.sources, source_id);
  ++world.version;
  return true;
}

bool remove_relation(RewardWorld& world, RelationKind kind, const std::string& from, const std::string& to) {
  const auto removed = std::erase_if(world.relations, [&](const Relation& relation) {
    return relation.kind == kind && relation.from == from && relation.to == to;
  });
  if (removed > 0) ++world.version;
  return removed > 0;
}

}  // namespace tandem
