#pragma once

#include <memory>
#include <vector>

#include "services/planner/core/motion/action_set.hpp"
#include "services/planner/core/search/search_area.hpp"
#include "services/planner/core/team/leg_book.hpp"

namespace tandem {

/// What a search is planned on.
struct SearchWorldOptions {
  SearchAreaOptions area;
  std::vector<Searcher> searchers;      ///< At least one.
  std::vector<double> lookout_range_m;  ///< Of each searcher; empty: its view.
  double least_gain_share = 0.0625;     ///< What a lookout must add, as a share of the disc of its range.
  int nearest = 16;                     ///< See ActionSetOptions.
};

/// What stays the same from plan to plan: the maps, the area on them, who sees what from where, and what each
/// capability can do.
class SearchWorld {
 public:
  /// `layers`: the map of the ground, then those above low walls, all alike in size and place.
  SearchWorld(std::vector<OccupancyGrid> layers, SearchWorldOptions options);
  SearchWorld(const SearchWorld&) = delete;  // its parts point at each other
  SearchWorld& operator=(const SearchWorld&) = delete;

  /// Lets the searchers of this one's capability find their ways anew around `blocked` places; `start_in_map` picks the
  /// part of the map they are in.
  void block(int searcher, const std::vector<BlockedDisc>& blocked, const Eigen::Vector2d& start_in_map);

  /// Prepares a little more ahead of need; false once all is done.
  bool prepare_next();
  /// Forgets the places added for the last plan.
  void forget_added_places();

  [[nodiscard]] const SearchArea& area() const { return area_; }
  [[nodiscard]] const OccupancyGrid& map(int layer) const { return layers_[static_cast<std::size_t>(layer)]; }
  [[nodiscard]] Observability& observability(int layer) { return *sights_[static_cast<std::size_t>(layer)]; }
  [[nodiscard]] const std::vector<Searcher>& searchers() const { return options_.searchers; }
  [[nodiscard]] const Searcher& searcher(int index) const {
    return options_.searchers[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] ViewTable& views(int searcher) { return *capability_of(searcher).views; }
  /// Shared by all of one capability.
  [[nodiscard]] ActionSet& actions(int searcher) { return *capability_of(searcher).actions; }
  /// The legs of actions() in short.
  [[nodiscard]] LegBook& book(int searcher) { return *capability_of(searcher).book; }
  /// The time these searchers would need to sweep the area once, each at its speed with its widest view [s].
  [[nodiscard]] double sweep_time_s(const std::vector<int>& searchers) const;

 private:
  struct Capability {
    Searcher searcher;
    ActionSetOptions options;
    std::unique_ptr<ViewTable> views;
    std::unique_ptr<ActionSet> actions;
    std::unique_ptr<LegBook> book;
  };
  [[nodiscard]] Capability& capability_of(int searcher) {
    return capabilities_[capability_index_[static_cast<std::size_t>(searcher)]];
  }

  std::vector<OccupancyGrid> layers_;
  SearchWorldOptions options_;
  SearchArea area_;
  std::vector<std::unique_ptr<Observability>> sights_;  ///< per layer
  std::vector<Capability> capabilities_;
  std::vector<std::size_t> capability_index_;  ///< per searcher
};

}  // namespace tandem
