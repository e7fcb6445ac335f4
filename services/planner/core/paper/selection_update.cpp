#include "services/planner/core/paper/selection_update.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

double reduction_factor(const SelectionUpdate& update, int actions_after) {
  const double discounted = std::pow(update.discount, actions_after);
  return update.reading == Reading::Sound ? 1.0 - (1.0 - update.reduction) * discounted : update.reduction * discounted;
}

void reduce_selection(ActionTree& tree, int last_action, const SelectionUpdate& update) {
  int actions_after = 0;
  for (int at = last_action; at > 0; at = tree[static_cast<std::size_t>(at)].parent, ++actions_after) {
    Action& above = tree[static_cast<std::size_t>(tree[static_cast<std::size_t>(at)].parent)];
    const auto which = std::ranges::find(above.eligible, at) - above.eligible.begin();
    above.selection[static_cast<std::size_t>(which)] *= reduction_factor(update, actions_after);
    normalise(above.selection);
  }
}

}  // namespace tandem
