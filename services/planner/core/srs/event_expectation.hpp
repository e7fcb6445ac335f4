#pragma once

#include "services/planner/core/srs/draw_list.hpp"

namespace tandem {

/// Events that happen as proportional pools are drawn from ("the object is found", digest A1, G6), in expectation.
///
/// The joint mass of a search cell is drawn with the probability that the object is detected there; the event happens
/// with the sum. Steady rewards that a soft relation ends with the event are paid only while it has not happened: they
/// count with that probability. Pools drain as if it had not happened: that is the course in which they are still
/// needed. A cell's own reward is a probability already.
class EventExpectation {
 public:
  /// At a time of the joint move, for the step that begins there.
  EventExpectation(const ResolvedWorld& world, const RewardState& state, const DrawList& draws, double now_s)
      : world_(world), state_(state), draws_(draws), now_s_(now_s) {}

  /// Whether the draw ends with an event that may have happened or may happen in the step.
  [[nodiscard]] bool concerns(const DrawList::Draw& draw) const;

  /// What the draw takes in the next `length_s` in expectation, signed.
  [[nodiscard]] double expected_amount(const DrawList::Draw& draw, const JointMove& joint, double length_s) const;

 private:
  [[nodiscard]] double probability(std::size_t event, double later_s) const;

  const ResolvedWorld& world_;
  const RewardState& state_;
  const DrawList& draws_;
  double now_s_;
};

}  // namespace tandem
