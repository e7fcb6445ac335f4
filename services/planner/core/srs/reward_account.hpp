#pragma once

#include <string>
#include <vector>

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// A straight move at constant speed, or a stay.
struct AgentMove {
  std::string agent;
  Eigen::Vector2d from_in_map;  ///< [m]
  Eigen::Vector2d to_in_map;    ///< [m]
};

/// What is left in the pools of a world during one course of events, and what the agents have drawn.
///
/// Drains continuously: pools run dry at an exact instant, agents that draw at once share in proportion to their rates,
/// and relations take effect at that instant (digest B5, C7). Splitting a move changes nothing.
class RewardAccount {
 public:
  /// `world` must have no problem_of() and outlive the account.
  explicit RewardAccount(const RewardWorld& world);

  /// All agents move for `duration_s` [s] at the same time; gives the reward of each of them.
  std::vector<double> advance(const std::vector<AgentMove>& moves, double duration_s);

  /// Consumes a source as a whole, as an event does ("found").
  void consume(std::size_t source);

  /// What is left in the pool, signed as the pool.
  [[nodiscard]] double left(std::size_t source) const;
  [[nodiscard]] bool is_consumed(std::size_t source) const { return consumed_[source]; }

 private:
  struct Draw;
  void drain(const std::vector<AgentMove>& moves, double duration_s, double from_s, double to_s,
             std::vector<double>& rewards);
  [[nodiscard]] bool pays(std::size_t source, const std::string& agent) const;

  const RewardWorld& world_;
  std::vector<double> left_;  ///< magnitude
  std::vector<bool> consumed_;
};

}  // namespace tandem
