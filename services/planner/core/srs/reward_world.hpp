#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/planner/core/srs/reward_source.hpp"

namespace tandem {

/// How the reward of one source depends on another (paper 3.2.1, digest C).
enum class RelationKind {
  Strict,       ///< `to` pays only after `from` is consumed
  Soft,         ///< `from` pays only before `to` is consumed
  Codependent,  ///< what is drawn from one also leaves the other, `coupling` times, both ways
};

/// An edge of the interdependence graph.
struct Relation {
  RelationKind kind = RelationKind::Soft;
  std::string from;
  std::string to;
  double coupling = 1.0;            ///< of a codependence, [0, 1]
  std::vector<std::string> agents;  ///< whose reward a soft relation silences; empty: everybody's (digest C6)
};

/// The sources of a task and how they depend on each other: W = {sources, graph}, equation (8).
struct RewardWorld {
  std::vector<RewardSource> sources;
  std::vector<Relation> relations;
};

/// The index of the source called `id`, if there is one.
[[nodiscard]] std::optional<std::size_t> index_of(const RewardWorld& world, const std::string& id);

/// What is wrong with the world, for people; none if it can be evaluated. A circle of strict relations is wrong: none
/// of its sources could ever pay.
[[nodiscard]] std::optional<std::string> problem_of(const RewardWorld& world);

}  // namespace tandem
