#pragma once

#include "services/planner/core/paper/action_tree.hpp"

namespace tandem {

/// How equation (14) is read: q' = q * w * gamma^n, with n actions between an action and the last one of its agent.
enum class Reading {
  Sound,   ///< q' = q * (1 - (1 - w) * gamma^n): w at the last action, ever less of a reduction before it
  Printed  ///< to the letter: the *stronger* a reduction the farther from the last action, against the paper's text
};

struct SelectionUpdate {
  double reduction = 0.5;  ///< w of the paper, in (0, 1)
  double discount = 0.8;   ///< gamma of the paper, in (0.5, 1)
  Reading reading = Reading::Sound;
};

/// What q of an action `actions_after` actions before the last one is multiplied with.
[[nodiscard]] double reduction_factor(const SelectionUpdate& update, int actions_after);

/// Makes the actions of the sequence to `last_action` less likely to be selected again, and their siblings more: q is
/// normalised among those eligible together (digest F2).
void reduce_selection(ActionTree& tree, int last_action, const SelectionUpdate& update);

}  // namespace tandem
