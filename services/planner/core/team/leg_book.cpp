#include "services/planner/core/team/leg_book.hpp"

#include <cmath>

namespace tandem {

LegBook::LegBook(ActionSet& actions)
    : actions_(actions),
      first_sight_(std::isinf(actions.searcher().detection_rate_per_s) && actions.searcher().sees_all_around()),
      rate_per_s_(actions.searcher().detection_rate_per_s) {}

void LegBook::forget_added_places() {
  const auto is_added = [&](const Entry& entry) { return entry.to >= actions_.lookouts(); };
  if (rows_.size() > static_cast<std::size_t>(actions_.lookouts())) {
    rows_.resize(static_cast<std::size_t>(actions_.lookouts()));
  }
  if (!added_.empty()) {
    for (auto& row : rows_) std::erase_if(row, is_added);
  }
  added_.clear();
}

bool LegBook::prepare_next() {
  if (prepared_ == actions_.lookouts()) return false;
  for (const int lookout : actions_.nearest_lookouts(prepared_)) (void)leg(prepared_, lookout);
  ++prepared_;
  return true;
}

void LegBook::add_first_sights(const Sightings& seen, bool came_there, CompactLeg& leg) {
  ++pass_;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto cell = static_cast<std::size_t>(seen.cells[i]);
    if (seen_in_.size() <= cell) seen_in_.resize(cell + 1, 0);
    if (seen_in_[cell] == pass_) continue;
    seen_in_[cell] = pass_;
    if (came_there && seen.enter_s[i] <= 0.0) continue;
    leg.cells.push_back(seen.cells[i]);
    leg.enter_s.push_back(static_cast<float>(seen.enter_s[i]));
  }
  leg.cells.shrink_to_fit();
  leg.enter_s.shrink_to_fit();
}

const CompactLeg& LegBook::add(int from, int to) {
  const bool stays = from < actions_.lookouts() && to < actions_.lookouts();
  CompactLeg& compact = (stays ? kept_ : added_).emplace_back();
  if (rows_.size() <= static_cast<std::size_t>(from)) rows_.resize(static_cast<std::size_t>(from) + 1);
  rows_[static_cast<std::size_t>(from)].push_back({to, &compact});
  const Leg& leg = actions_.leg(from, to);
  compact.possible = leg.possible();
  if (!compact.possible) return compact;
  compact.duration_s = static_cast<float>(leg.duration_s);
  compact.initial_heading_rad = static_cast<float>(leg.initial_heading_rad);
  compact.final_heading_rad = static_cast<float>(leg.final_heading_rad);
  if (first_sight_) {
    add_first_sights(leg.seen, from < actions_.lookouts(), compact);
    return compact;
  }
  compact.cells = leg.seen.cells;
  compact.enter_s.assign(leg.seen.enter_s.begin(), leg.seen.enter_s.end());
  compact.end_view = leg.stay.cells;
  for (std::size_t i = 0; i < leg.seen.size(); ++i) {
    const double stay_s = leg.seen.leave_s[i] - leg.seen.enter_s[i];
    compact.stay_s.push_back(static_cast<float>(stay_s));
    compact.kept.push_back(static_cast<float>(std::isinf(rate_per_s_) ? 0.0 : std::exp(-rate_per_s_ * stay_s)));
  }
  return compact;
}

}  // namespace tandem
