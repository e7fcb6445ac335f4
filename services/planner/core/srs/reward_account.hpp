#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planner/core/srs/draw_list.hpp"
#include "services/planner/core/srs/reward_state.hpp"

namespace tandem {

/// Something that happened at an instant.
struct RewardEvent {
  enum class Kind {
    Exhausted,  ///< the pool of the source ran dry
    Triggered,  ///< a relation that waited for the source took effect
    Consumed,   ///< from outside
  };
  Kind kind = Kind::Exhausted;
  std::size_t source = 0;  ///< of a group: its first member
  double time_s = 0.0;     ///< since the account began
  AgentMask agents = 0;    ///< that were drawing at that instant; none if a codependent source took the last of it
};

/// What an account writes down if asked to.
struct RewardRecord {
  std::vector<RewardEvent> events;  ///< by time
  std::vector<double> paid;         ///< reward of each source to each agent: [source * agents + agent]
};

/// What is left in the pools of a world during one course of events, and what the agents draw.
///
/// Drains continuously: pools run dry at an exact instant, agents that draw at once share in proportion to what they
/// draw per second, and relations take effect at that instant (digest B5, C7). Splitting a move changes nothing.
/// After the first advances nothing is allocated any more.
class RewardAccount {
 public:
  /// `world` must outlive the account.
  explicit RewardAccount(const ResolvedWorld& world);

  /// All agents move for `duration_s` [s] at the same time; adds to `rewards` what each of them gets. Both by agent
  /// number, as many as the world has agents.
  void advance(std::span<const AgentMove> moves, double duration_s, std::span<double> rewards);

  /// As advance, but stops at the instant the pool of `source` is empty. Gives the time that has gone by [s]; the rest
  /// of the moves is the caller's to go on with.
  double advance_until_consumed(std::size_t source, std::span<const AgentMove> moves, double duration_s,
                                std::span<double> rewards);

  /// Consumes a source as a whole from outside, as an event does ("found").
  void consume(std::size_t source);

  /// What is left in the source's pool, signed as the pool.
  [[nodiscard]] double left(std::size_t source) const;
  /// How much has gone from the source's pool, magnitude; of an event, the probability that it has happened by now.
  [[nodiscard]] double drawn(std::size_t source) const;
  [[nodiscard]] bool is_consumed(std::size_t source) const;
  /// Whether the relations let the source pay the agent now; its pool is not asked.
  [[nodiscard]] bool is_open(std::size_t source, std::size_t agent) const;
  /// Whether the source has anything left for the agent, now or once its predecessors are consumed; reward of the other
  /// sign than the pool's aside.
  [[nodiscard]] bool can_pay(std::size_t source, std::size_t agent) const;
  [[nodiscard]] double time_s() const { return state_.time_s; }

  /// To come back later: keep a copy, and restore it.
  [[nodiscard]] const RewardState& state() const { return state_; }
  void restore(const RewardState& state) { state_ = state; }

  /// From now on writes into `record`, which must outlive its use; nullptr: nothing.
  void record_to(RewardRecord* record);

  [[nodiscard]] const ResolvedWorld& world() const { return *world_; }

 private:
  double run(const JointMove& joint, std::size_t watched_pool, std::span<double> rewards);
  /// Nobody crosses a boundary between the two shares.
  double run_part(const JointMove& joint, double from_share, double to_share, std::size_t watched_pool,
                  std::span<double> rewards);
  bool open_on_entry(double time_s);
  void pay(const JointMove& joint, double now_s, const DrawList::Step& step, std::span<double> rewards);
  void take(const DrawList::Step& step, double time_s);
  void take_from_pool(std::size_t pool, double amount, double time_s);
  void pass_gates(std::size_t pool, double time_s);
  void note(RewardEvent::Kind kind, std::size_t pool, double time_s);

  const ResolvedWorld* world_;
  RewardState state_;
  RewardRecord* record_ = nullptr;
  DrawList draws_;
};

}  // namespace tandem
