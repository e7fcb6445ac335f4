// What can be wrong with a world.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {
namespace {

using Problem = std::optional<WorldProblem>;

std::string place(const char* list, std::size_t index) {
  return std::string{list} + "[" + std::to_string(index) + "]";
}

/// Everything that asks for the same question in several lists.
class WorldCheck {
 public:
  explicit WorldCheck(const RewardWorld& world) : world_(world) {
    for (const auto& source : world.sources) ids_.insert(source.id);
  }

  Problem first_problem() const {
    if (auto problem = of_agents()) return problem;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < world_.sources.size(); ++i) {
      const std::string where = place("sources", i);
      if (world_.sources[i].id.empty()) return WorldProblem{where + ": id", "must not be empty"};
      if (!seen.insert(world_.sources[i].id).second) {
        return WorldProblem{where + ": id", "two sources are called \"" + world_.sources[i].id + "\""};
      }
      if (auto problem = of_source(world_.sources[i], where)) return problem;
    }
    if (auto problem = of_groups()) return problem;
    for (std::size_t i = 0; i < world_.relations.size(); ++i) {
      if (auto problem = of_relation(i, place("relations", i))) return problem;
    }
    if (auto problem = of_strict_circle()) return problem;
    return of_unawareness();
  }

 private:
  Problem of_agents() const {
    if (world_.agents.size() > kMaxAgents) {
      return WorldProblem{"agents", "more than " + std::to_string(kMaxAgents) + " agents"};
    }
    std::set<std::string> seen;
    for (const auto& agent : world_.agents) {
      if (agent.empty()) return WorldProblem{"agents", "an agent has no name"};
      if (!seen.insert(agent).second) return WorldProblem{"agents", "two agents are called \"" + agent + "\""};
    }
    return std::nullopt;
  }

  Problem of_agent(const std::string& agent, const std::string& where) const {
    if (agent_index_of(world_, agent)) return std::nullopt;
    std::string known;
    for (const auto& one : world_.agents) known += (known.empty() ? "" : ", ") + one;
    return WorldProblem{where, "no agent is called \"" + agent + "\"; known: " + known};
  }

  Problem of_source(const RewardSource& source, const std::string& where) const {
    if (const auto what = problem_of(source.boundary)) return WorldProblem{where + ": boundary", *what};
    for (const auto& owner : owners_of(source.boundary)) {
      if (auto problem = of_agent(owner, where + ": boundary")) return problem;
    }
    if (const auto what = problem_of(source.inside)) return WorldProblem{where + ": inside", *what};
    if (const auto what = problem_of(source.outside)) return WorldProblem{where + ": outside", *what};
    for (const auto& target : source.targets) {
      if (auto problem = of_agent(target, where + ": targets")) return problem;
    }
    for (const auto& temper : source.tempers) {
      if (auto problem = of_agent(temper.agent, where + ": tempers")) return problem;
      if (!(temper.pace >= 0.0) || !std::isfinite(temper.pace) || !std::isfinite(temper.worth)) {
        return WorldProblem{where + ": tempers: " + temper.agent, "pace must be at least 0, both must be finite"};
      }
    }
    if (source.flow == Flow::Proportional) {
      if (!std::isfinite(source.pool))
        return WorldProblem{where + ": pool", "a proportional flow needs a limited pool"};
      if (!is_constant(source.inside) || source.outside != RewardRatio{} || source.inside.boundary_per_s < 0.0 ||
          source.pool < 0.0) {
        return WorldProblem{where + ": flow",
                            "a proportional flow needs a constant inner ratio of at least 0, no outer "
                            "ratio, and a pool that is not negative"};
      }
      return std::nullopt;
    }
    return of_pool(source.pool, source, where);
  }

  static Problem of_pool(double pool, const RewardSource& source, const std::string& where) {
    if (std::isnan(pool)) return WorldProblem{where + ": pool", "must be a number"};
    if (!std::isfinite(pool)) return std::nullopt;
    if (pool == 0.0) return WorldProblem{where + ": pool", "a pool of 0 never pays; leave it out if it has no limit"};
    if (std::holds_alternative<Nowhere>(source.boundary)) return std::nullopt;
    if (pool * peak_of(source.inside) <= 0.0 && pool * peak_of(source.outside) <= 0.0) {
      return WorldProblem{where + ": pool", "has the wrong sign: neither ratio can draw on it"};
    }
    return std::nullopt;
  }

  Problem of_groups() const {
    std::set<std::string> seen;
    std::set<std::string> grouped;
    for (std::size_t i = 0; i < world_.groups.size(); ++i) {
      const SourceGroup& group = world_.groups[i];
      const std::string where = place("groups", i);
      if (group.id.empty() || !seen.insert(group.id).second) {
        return WorldProblem{where + ": id", "must be there, and another one than that of the other groups"};
      }
      if (group.members.empty()) return WorldProblem{where + ": members", "must not be empty"};
      double sign = 0.0;
      for (const auto& member : group.members) {
        if (auto problem = of_source_id(member, where + ": members")) return problem;
        if (!grouped.insert(member).second) {
          return WorldProblem{where + ": members", "\"" + member + "\" is in a group already"};
        }
        const RewardSource& source = world_.sources[*index_of(world_, member)];
        if (std::isfinite(source.pool) || source.flow == Flow::Proportional ||
            std::holds_alternative<Nowhere>(source.boundary)) {
          return WorldProblem{where + ": members", "\"" + member +
                                                       "\" must have a place, a steady flow, and no pool of "
                                                       "its own: the group has it"};
        }
        for (const double peak : {peak_of(source.inside), peak_of(source.outside)}) {
          if (sign * peak < 0.0) return WorldProblem{where + ": members", "some attract and some repel"};
          if (peak != 0.0) sign = peak;
        }
        if (auto problem = of_pool(group.pool, source, where)) return problem;
      }
    }
    return std::nullopt;
  }

  Problem of_source_id(const std::string& id, const std::string& where) const {
    if (ids_.contains(id)) return std::nullopt;
    return WorldProblem{where, "no source is called \"" + id + "\""};
  }

  double pool_of(const std::string& id) const {
    const SourceGroup* group = group_of(world_, id);
    return group != nullptr ? group->pool : world_.sources[*index_of(world_, id)].pool;
  }

  Problem of_relation(std::size_t index, const std::string& where) const {
    const Relation& relation = world_.relations[index];
    if (auto problem = of_source_id(relation.from, where + ": from")) return problem;
    if (auto problem = of_source_id(relation.to, where + ": to")) return problem;
    if (relation.from == relation.to) return WorldProblem{where, "relates \"" + relation.to + "\" to itself"};
    for (std::size_t i = 0; i < index; ++i) {
      const Relation& other = world_.relations[i];
      if (other.kind == relation.kind && other.from == relation.from && other.to == relation.to) {
        return WorldProblem{where, "is there already: " + place("relations", i)};
      }
    }
    for (const auto& agent : relation.agents) {
      if (auto problem = of_agent(agent, where + ": agents")) return problem;
    }
    if (relation.kind == RelationKind::Codependent) return of_codependence(index, where);
    return of_trigger(relation, where);
  }

  /// A codependence is between pools, and goes both ways: there is at most one between two of them.
  bool couples_the_same(const Relation& one, const Relation& other) const {
    const std::set<std::string> pools{node_of(one.from), node_of(one.to)};
    return other.kind == RelationKind::Codependent &&
           pools == std::set<std::string>{node_of(other.from), node_of(other.to)};
  }

  Problem of_codependence(std::size_t index, const std::string& where) const {
    const Relation& relation = world_.relations[index];
    for (std::size_t i = 0; i < index; ++i) {
      if (couples_the_same(relation, world_.relations[i])) {
        return WorldProblem{where, "the two are codependent already: " + place("relations", i)};
      }
    }
    if (!(relation.coupling >= 0.0 && relation.coupling <= 1.0)) {
      return WorldProblem{where + ": coupling", "must be in [0, 1]"};
    }
    const SourceGroup* group = group_of(world_, relation.from);
    if (group != nullptr && group == group_of(world_, relation.to)) {
      return WorldProblem{where, "both are in group \"" + group->id + "\", which has one pool already"};
    }
    for (const auto& id : {relation.from, relation.to}) {
      if (world_.sources[*index_of(world_, id)].flow == Flow::Proportional) {
        return WorldProblem{where, "\"" + id + "\" pays in proportion to what is left and cannot be codependent"};
      }
    }
    return std::nullopt;
  }

  Problem of_trigger(const Relation& relation, const std::string& where) const {
    const std::string& watched = relation.kind == RelationKind::Strict ? relation.from : relation.to;
    const Trigger& trigger = relation.trigger;
    const double pool = pool_of(watched);
    const bool is_event = std::holds_alternative<Nowhere>(world_.sources[*index_of(world_, watched)].boundary);
    if (is_event && trigger != Trigger{}) {
      return WorldProblem{where + ": trigger", "an event happens as a whole; leave it out"};
    }
    if (trigger.kind == Trigger::Kind::Fraction && !(trigger.value > 0.0 && trigger.value <= 1.0)) {
      return WorldProblem{where + ": trigger", "a fraction must be in (0, 1]"};
    }
    if (trigger.kind == Trigger::Kind::Fraction && !std::isfinite(pool) && !is_event) {
      return WorldProblem{where + ": trigger", "\"" + watched +
                                                   "\" has no limit and is never consumed; give an amount "
                                                   "or an entry"};
    }
    if (trigger.kind == Trigger::Kind::Amount &&
        !(trigger.value > 0.0 && std::isfinite(trigger.value) && trigger.value <= std::abs(pool))) {
      return WorldProblem{where + ": trigger", "an amount must be greater than 0 and at most the pool"};
    }
    return std::nullopt;
  }

  /// Follows strict relations from pool to pool; who comes back to where it was has found a circle.
  Problem of_strict_circle() const {
    std::set<std::string> done;
    for (const auto& source : world_.sources) {
      std::vector<std::string> path;
      if (auto problem = circle_from(source.id, path, done)) return problem;
    }
    return std::nullopt;
  }

  /// Members of a group wait for each other's pool: it is one node.
  std::string node_of(const std::string& id) const {
    const SourceGroup* group = group_of(world_, id);
    return group != nullptr ? "group " + group->id : id;
  }

  Problem circle_from(const std::string& id, std::vector<std::string>& path, std::set<std::string>& done) const {
    const std::string node = node_of(id);
    const auto seen = std::ranges::find(path, node);
    if (seen != path.end()) {
      std::string circle;
      for (auto it = seen; it != path.end(); ++it) circle += *it + " => ";
      return WorldProblem{"relations",
                          "strict precedence goes in a circle, none of it could ever pay: " + circle + node};
    }
    if (done.contains(node)) return std::nullopt;
    path.push_back(node);
    for (const auto& relation : world_.relations) {
      if (relation.kind != RelationKind::Strict || node_of(relation.from) != node) continue;
      if (auto problem = circle_from(relation.to, path, done)) return problem;
    }
    path.pop_back();
    done.insert(node);
    return std::nullopt;
  }

  Problem of_unawareness() const {
    if (!(world_.message_cost >= 0.0) || !std::isfinite(world_.message_cost)) {
      return WorldProblem{"message_cost", "must be at least 0"};
    }
    std::set<std::string> seen;
    for (const auto& unaware : world_.unawareness) {
      const std::string where = "knowledge: " + unaware.agent;
      if (auto problem = of_agent(unaware.agent, where)) return problem;
      if (!seen.insert(unaware.agent).second) return WorldProblem{where, "is there twice"};
      for (const auto& id : unaware.sources) {
        if (auto problem = of_source_id(id, where)) return problem;
      }
    }
    return std::nullopt;
  }

  const RewardWorld& world_;
  std::set<std::string> ids_;
};

}  // namespace

std::optional<WorldProblem> problem_of(const RewardWorld& world) {
  return WorldCheck{world}.first_problem();
}

}  // namespace tandem
