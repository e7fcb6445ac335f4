#pragma once

#include <limits>
#include <span>
#include <vector>

#include "services/planner/core/srs/reward_state.hpp"

namespace tandem {

/// Who draws from what in a part of a joint move, and how fast: the arithmetic of a RewardAccount.
///
/// It keeps its memory from move to move.
class DrawList {
 public:
  /// An agent that can come into contact with a source in this move.
  struct Contact {
    std::size_t pool = 0;
    std::size_t agent = 0;
    std::size_t source = 0;
    bool inside = false;  ///< in the part of the move that is looked at
    bool open = false;    ///< pool and relations let it pay in the step that is looked at
  };

  /// An agent that draws from a pool now.
  struct Draw {
    std::size_t pool = 0;
    std::size_t agent = 0;
    std::size_t source = 0;  ///< the strongest of a group
    std::size_t first = 0;   ///< of its contacts
    std::size_t last = 0;    ///< one past
    bool constant = true;    ///< else per_s is only its sign and peak
    bool takes = false;      ///< it lessens the pool, or counts as drawn from an unlimited one
    double per_s = 0.0;      ///< in units of the source, signed
    double amount = 0.0;     ///< that it draws in the step, magnitude
  };

  /// The longest time in which no pool runs dry and no gate is reached.
  struct Step {
    double length_s = 0.0;
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t ended_by = kNone;  ///< the pool that ends it
    double amount = 0.0;           ///< that this pool gives until then
  };

  /// Finds the contacts of a joint move and the shares at which any of them begins, ends, or has a kink.
  void begin_move(const ResolvedWorld& world, const RewardState& state, const JointMove& joint);
  /// Ascending, from 0 to 1.
  [[nodiscard]] const std::vector<double>& shares() const { return shares_; }

  /// Decides for each contact whether it is inside between two neighbouring shares.
  void begin_part(const ResolvedWorld& world, const JointMove& joint, double from_share, double to_share);
  [[nodiscard]] std::vector<Contact>& contacts() { return contacts_; }

  /// Finds who draws now.
  void begin_step(const ResolvedWorld& world, const RewardState& state);
  [[nodiscard]] std::vector<Draw>& draws() { return draws_; }
  /// Nobody draws any more.
  void clear() { draws_.clear(); }
  /// The pools that anything is drawn from now, codependent ones included; ascending.
  [[nodiscard]] const std::vector<std::size_t>& pools() const { return pools_; }

  [[nodiscard]] Step longest_step(const ResolvedWorld& world, const RewardState& state, const JointMove& joint,
                                  double now_s, double end_s) const;

  /// What the draw takes per second at a time of the joint move, signed.
  [[nodiscard]] double per_s_at(const Draw& draw, const ResolvedWorld& world, const JointMove& joint,
                                double time_s) const;
  /// What a draw from a steady pool takes in a while from a time on, signed.
  [[nodiscard]] double steady_amount(const Draw& draw, const ResolvedWorld& world, const JointMove& joint,
                                     double from_s, double length_s) const;
  /// What is drawn per second from a pool by those who take from it directly, if that is constant.
  [[nodiscard]] double outflow_per_s(std::size_t pool) const { return outflow_per_s_[pool]; }

 private:
  void add_contact(const ResolvedWorld& world, const RewardState& state, const JointMove& joint, std::size_t pool,
                   std::size_t agent, std::size_t source);
  void add_draw(const ResolvedWorld& world, const RewardState& state, std::size_t first, std::size_t last);
  [[nodiscard]] double time_until(double amount, std::size_t pool, const ResolvedWorld& world, const RewardState& state,
                                  const JointMove& joint, double now_s, double end_s) const;
  /// What leaves a steady pool in a while from a time on, through codependence too.
  [[nodiscard]] double loss(std::size_t pool, const ResolvedWorld& world, const JointMove& joint, double from_s,
                            double length_s) const;
  [[nodiscard]] double own_loss(std::size_t pool, const ResolvedWorld& world, const JointMove& joint, double from_s,
                                double length_s) const;

  std::vector<Contact> contacts_;
  std::vector<double> shares_;
  std::vector<Draw> draws_;
  std::vector<std::size_t> pools_;
  std::vector<double> outflow_per_s_;  ///< by pool: of constant draws
  std::vector<std::uint8_t> varies_;   ///< by pool: whether some draws are not constant
};

}  // namespace tandem
