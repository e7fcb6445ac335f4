#include "services/planner/core/srs/reward_world.hpp"

#include <cmath>
#include <set>

namespace tandem {
namespace {

/// Takes away sources that wait for nobody until none is left; what remains waits in a circle.
bool has_strict_circle(const RewardWorld& world) {
  std::set<std::string> waiting;
  for (const auto& source : world.sources) waiting.insert(source.id);
  bool shrinking = true;
  while (shrinking) {
    shrinking = false;
    for (auto it = waiting.begin(); it != waiting.end();) {
      bool waits = false;
      for (const auto& relation : world.relations) {
        waits |= relation.kind == RelationKind::Strict && relation.to == *it && waiting.contains(relation.from);
      }
      shrinking |= !waits;
      it = waits ? std::next(it) : waiting.erase(it);
    }
  }
  return !waiting.empty();
}

}  // namespace

std::optional<std::size_t> index_of(const RewardWorld& world, const std::string& id) {
  for (std::size_t i = 0; i < world.sources.size(); ++i) {
    if (world.sources[i].id == id) return i;
  }
  return std::nullopt;
}

std::optional<std::string> problem_of(const RewardWorld& world) {
  std::set<std::string> ids;
  for (const auto& source : world.sources) {
    if (!ids.insert(source.id).second) return "two sources are called " + source.id;
    if (source.outer_rate_per_s != 0.0 && std::isfinite(source.pool)) {
      return source.id + " pays outside its boundary and has a limited pool";
    }
    if (source.flow == Flow::Proportional && !std::isfinite(source.pool)) {
      return source.id + " pays in proportion to an unlimited pool";
    }
  }
  for (const auto& relation : world.relations) {
    for (const auto& id : {relation.from, relation.to}) {
      if (!ids.contains(id)) return "a relation names the unknown source " + id;
    }
    if (relation.coupling < 0.0 || relation.coupling > 1.0) return "a coupling is outside [0, 1]";
  }
  if (has_strict_circle(world)) return "strict relations form a circle";
  return std::nullopt;
}

}  // namespace tandem
