#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "services/planner/core/motion/action_set.hpp"

namespace tandem {

/// A leg as the inner loops of planning read it: single precision, one array behind the other.
struct CompactLeg {
  float duration_s = 0.0F;
  float initial_heading_rad = 0.0F;
  float final_heading_rad = 0.0F;
  bool possible = false;
  std::vector<std::int32_t> cells;     ///< that come into view, again if they come back
  std::vector<float> enter_s;          ///< when, from the beginning of the leg, ascending
  std::vector<float> stay_s;           ///< for how long; empty if seen is found
  std::vector<float> kept;             ///< the share of a cell's mass that is left then; empty if seen is found
  std::vector<std::int32_t> end_view;  ///< in view at the end, while the agent turns; empty if it need not turn
};

/// The legs of one capability between places that are near to each other, of which every plan consists. Of a searcher
/// to whom seen is found a leg has each cell once, when it first comes into view; what is in view when a leg from a
/// lookout begins is left out: it was seen on arrival.
class LegBook {
 public:
  /// `actions` must outlive it and must not forget its lookouts.
  explicit LegBook(ActionSet& actions);

  /// Finds the legs from one more lookout to those nearest to it ahead of need; false once all are there.
  bool prepare_next();
  /// Forgets the legs of places that were added for the last plan.
  void forget_added_places();
  /// The leg from one place to another near it; stays where it is until its places are forgotten.
  [[nodiscard]] const CompactLeg& leg(int from, int to) {
    if (static_cast<std::size_t>(from) < rows_.size()) {
      for (const Entry& entry : rows_[static_cast<std::size_t>(from)]) {
        if (entry.to == to) return *entry.leg;
      }
    }
    return add(from, to);
  }
  [[nodiscard]] bool first_sight() const { return first_sight_; }
  [[nodiscard]] ActionSet& actions() { return actions_; }

 private:
  struct Entry {
    std::int32_t to;
    const CompactLeg* leg;
  };
  [[nodiscard]] const CompactLeg& add(int from, int to);
  /// Each cell when it first comes into view; with `came_there` without those in view from the beginning.
  void add_first_sights(const Sightings& seen, bool came_there, CompactLeg& leg);

  ActionSet& actions_;
  bool first_sight_ = false;
  double rate_per_s_ = 0.0;
  int prepared_ = 0;                      ///< lookouts, from the first
  std::vector<std::vector<Entry>> rows_;  ///< per place: the few near to it
  std::deque<CompactLeg> kept_;           ///< between lookouts
  std::deque<CompactLeg> added_;          ///< from or to added places
  std::vector<std::uint32_t> seen_in_;    ///< per cell, the last leg made that has it
  std::uint32_t pass_ = 0;
};

}  // namespace tandem
