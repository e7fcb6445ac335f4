#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/planner/core/srs/resolved_boundary.hpp"
#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// A set of agents: bit i is the agent with number i.
using AgentMask = std::uint32_t;

[[nodiscard]] constexpr AgentMask mask_of(std::size_t agent) {
  return AgentMask{1} << agent;
}

/// A source with numbers instead of names.
struct ResolvedSource {
  ResolvedBoundary boundary;
  std::optional<Disc> reach;  ///< a disc on the map outside which it pays nothing; none: no such disc
  RewardRatio inside;
  RewardRatio outside;
  SourceKind kind = SourceKind::Task;
  Flow flow = Flow::Steady;
  AgentMask targets = 0;
  std::size_t pool = 0;
  std::vector<double> pace;              ///< by agent
  std::vector<double> worth;             ///< by agent
  std::vector<std::size_t> opened_by;    ///< gates (of strict relations) that must all be through before it pays
  std::vector<std::size_t> silenced_by;  ///< gates (of soft relations) of which one is enough
  std::vector<std::size_t> expected_by;  ///< those of silenced_by that wait for an event, if the flow is steady
};

/// What the sources of a group, or one source alone, draw from.
struct ResolvedPool {
  double size = 0.0;  ///< signed; infinite if permanent
  Flow flow = Flow::Steady;
  std::vector<std::size_t> sources;
  std::vector<std::size_t> gates;  ///< that wait for this pool
  struct Coupling {
    std::size_t pool = 0;
    double coupling = 0.0;
  };
  std::vector<Coupling> couplings;  ///< what is drawn here also leaves there
  std::vector<std::size_t> feeds;   ///< events (pools) that happen as this proportional pool is drawn from
  bool is_event = false;
};

/// A strict or soft relation: once its pool is drawn from far enough, it is through for good.
struct ResolvedGate {
  std::size_t pool = 0;
  double amount = 0.0;  ///< that must have been drawn, magnitude; infinite if it waits for an entry
  bool on_entry = false;
  AgentMask agents = 0;      ///< whom a soft one silences
  std::size_t relation = 0;  ///< in RewardWorld::relations
};

/// A world made ready for evaluation: names resolved once, sources gathered by pool. Immutable; share it among
/// accounts.
class ResolvedWorld {
 public:
  /// `world` must have no problem_of().
  explicit ResolvedWorld(RewardWorld world);

  [[nodiscard]] const RewardWorld& world() const { return world_; }
  [[nodiscard]] std::size_t agent_count() const { return world_.agents.size(); }
  [[nodiscard]] const std::vector<ResolvedSource>& sources() const { return sources_; }  ///< as in world().sources
  [[nodiscard]] const std::vector<ResolvedPool>& pools() const { return pools_; }
  [[nodiscard]] const std::vector<ResolvedGate>& gates() const { return gates_; }

 private:
  void resolve_pools();
  void resolve_sources();
  void resolve_relations();

  RewardWorld world_;
  std::vector<ResolvedSource> sources_;
  std::vector<ResolvedPool> pools_;
  std::vector<ResolvedGate> gates_;
};

/// The reward of a second for the agent at a share of the joint move, with a full pool and all gates open [1/s]:
/// what it draws times what that is worth to it. Zero if it is no target.
[[nodiscard]] double rate_of(const ResolvedSource& source, std::size_t agent, const JointMove& joint, double share);

/// The most that a second can be worth to the agent, wherever it is: of the largest magnitude, signed [1/s].
[[nodiscard]] double peak_rate_of(const ResolvedSource& source, std::size_t agent);

}  // namespace tandem
