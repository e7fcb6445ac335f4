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
  std::size_t begin = 0;
  const bool came_there = first_sight_ && from < actions_.lookouts();
  while (came_there && begin < leg.seen.size() && leg.seen.enter_s[begin] <= 0.0) ++begin;
  compact.cells.assign(leg.seen.cells.begin() + static_cast<std::ptrdiff_t>(begin), leg.seen.cells.end());
  compact.enter_s.assign(leg.seen.enter_s.begin() + static_cast<std::ptrdiff_t>(begin), leg.seen.enter_s.end());
  if (first_sight_) return compact;
  compact.end_view = leg.stay.cells;
  for (std::size_t i = 0; i < leg.seen.size(); ++i) {
    const double stay_s = leg.seen.leave_s[i] - leg.seen.enter_s[i];
    compact.stay_s.push_back(static_cast<float>(stay_s));
    compact.kept.push_back(static_cast<float>(std::isinf(rate_per_s_) ? 0.0 : std::exp(-rate_per_s_ * stay_s)));
  }
  return compact;
}

}  // namespace tandem
