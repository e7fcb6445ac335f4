#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/planner/core/srs/reward_source.hpp"

namespace tandem {

/// How the reward of one source depends on another (paper 3.2.1, digest C).
enum class RelationKind {
  Strict,       ///< `to` pays only after `from` is consumed; of several, after all
  Soft,         ///< `from` pays only before `to` is consumed; of several, before any
  Codependent,  ///< what is drawn from one also leaves the other, `coupling` times, both ways, without cascade
};

/// When a source counts as consumed, for a strict or soft relation (digest C2).
struct Trigger {
  enum class Kind {
    Fraction,  ///< `value` in (0, 1] of the pool is gone, whoever drew it; 1: it is empty
    Amount,    ///< `value` > 0 in the units of the source has been drawn: the way to trigger an unlimited source
    Entry,     ///< a target has been inside while the source was open to it
  };
  Kind kind = Kind::Fraction;
  double value = 1.0;
  bool operator==(const Trigger&) const = default;
};

/// An edge of the interdependence graph.
struct Relation {
  RelationKind kind = RelationKind::Soft;
  std::string from;
  std::string to;
  Trigger trigger;                  ///< on `from` if strict, on `to` if soft
  double coupling = 1.0;            ///< kappa of a codependence, [0, 1]
  std::vector<std::string> agents;  ///< whose reward a soft relation silences; empty: everybody's (digest C6)
  bool operator==(const Relation&) const = default;
};

/// Sources that are one thing: they share one pool, and who is inside several of them draws from the strongest only.
struct SourceGroup {
  std::string id;
  std::vector<std::string> members;                       ///< sources without a pool of their own, all of one sign
  double pool = std::numeric_limits<double>::infinity();  ///< signed
  bool operator==(const SourceGroup&) const = default;
};

/// What somebody believes that an agent does not know (11).
struct Unawareness {
  std::string agent;
  std::vector<std::string> sources;  ///< that it does not know
  bool operator==(const Unawareness&) const = default;
};

/// The agents, the sources of a task, how they depend on each other, and who knows what: {Psi_Team, G_I} (8), (12).
struct RewardWorld {
  std::vector<std::string> agents;  ///< an agent's number everywhere is its place here; at most kMaxAgents
  std::vector<RewardSource> sources;
  std::vector<Relation> relations;
  std::vector<SourceGroup> groups;
  std::vector<Unawareness> unawareness;
  double message_cost = 0.0;  ///< What it costs to tell an agent about one source, >= 0.
  std::uint64_t version = 0;  ///< Counts the edits (9).

  bool operator==(const RewardWorld&) const = default;
};

inline constexpr std::size_t kMaxAgents = 32;

[[nodiscard]] std::optional<std::size_t> index_of(const RewardWorld& world, const std::string& source_id);
[[nodiscard]] std::optional<std::size_t> agent_index_of(const RewardWorld& world, const std::string& agent);
[[nodiscard]] const SourceGroup* group_of(const RewardWorld& world, const std::string& source_id);

/// What is wrong with a world, and where in its file: "sources[2]: inside".
struct WorldProblem {
  std::string where;
  std::string what;
};

/// The first thing that is wrong with the world; none if it can be evaluated.
[[nodiscard]] std::optional<WorldProblem> problem_of(const RewardWorld& world);

// Online edits (9). Each that changes something raises the version; one that would leave a world with a problem changes
// nothing and says what is wrong.

std::optional<WorldProblem> add_source(RewardWorld& world, const RewardSource& source);
std::optional<WorldProblem> add_relation(RewardWorld& world, const Relation& relation);
/// Removes the source with its relations, from its group, and from what agents do not know. False if there is none.
bool remove_source(RewardWorld& world, const std::string& source_id);
/// Removes the relations of this kind between the two. False if there is none.
bool remove_relation(RewardWorld& world, RelationKind kind, const std::string& from, const std::string& to);

}  // namespace tandem
