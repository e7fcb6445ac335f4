#pragma once

#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "services/planner/core/motion/lookouts.hpp"
#include "services/planner/core/motion/timed_path.hpp"

namespace tandem {

/// That an object in a search cell is detected on the way, if it lies there.
struct Look {
  int cell = -1;
  double probability = 0.0;
};

/// An action: going from one place of an action set to another, and what is seen on the way.
struct Leg {
  std::vector<Eigen::Vector2d> way;  ///< [m]; empty: no way leads there
  double initial_heading_rad = 0.0;
  double final_heading_rad = 0.0;
  std::vector<int> views;   ///< of each step, numbers of views of the action set
  std::vector<Look> looks;  ///< what is seen, each cell once

  [[nodiscard]] bool possible() const { return !way.empty(); }
  [[nodiscard]] int steps() const { return static_cast<int>(views.size()); }
};

struct ActionSetOptions {
  double step_s = 0.5;           ///< time is counted in steps
  double lookout_range_m = 2.5;  ///< lookouts are so dense that all is seen from this near
  double least_gain_m2 = 1.0;
  int nearest = 14;  ///< lookouts looked at first from each place
};

/// What one agent can do: go from lookout to lookout, sequences of which are its plans (digest E1, E2).
///
/// Places 0 .. lookouts() - 1 are the lookouts, which stay from plan to plan; start and goal of one plan are added
/// behind them. Ways and views are found when first asked for and kept.
class ActionSet {
 public:
  /// `observability` must outlive it. `start_in_map` picks the part of the map the agent is in.
  ActionSet(const OccupancyGrid& map, Observability& observability, const Searcher& searcher,
            const ActionSetOptions& options, const Eigen::Vector2d& start_in_map,
            const std::vector<BlockedDisc>& blocked = {});

  /// Finds ways and views of one more lookout ahead of need; false once all are there.
  bool prepare_next();
  /// Forgets the places added for the last plan.
  void forget_added_places();
  /// Adds a start or goal: the nearest place it can stand at within `reach_m`; none if there is none.
  [[nodiscard]] std::optional<int> add_place(const Eigen::Vector2d& point_in_map, double reach_m);

  [[nodiscard]] int lookouts() const { return lookout_count_; }
  [[nodiscard]] const Eigen::Vector2d& place(int index) const;
  /// Whether a way leads from one place to the other.
  [[nodiscard]] bool is_connected(int from, int to) { return std::isfinite(distance_m(from, to)); }
  /// How far it is from one place to another, clearance counted [m].
  [[nodiscard]] double distance_m(int from, int to);
  [[nodiscard]] const Leg& leg(int from, int to);
  /// The lookouts nearest to a place, itself not among them.
  [[nodiscard]] const std::vector<int>& nearest_lookouts(int from);
  [[nodiscard]] const View& view(int number) const { return views_[static_cast<std::size_t>(number)]; }
  /// What a lookout shows to all sides, to guess what a far one is worth.
  [[nodiscard]] const View& panorama(int lookout);
  [[nodiscard]] const Searcher& searcher() const { return searcher_; }
  [[nodiscard]] double step_s() const { return options_.step_s; }
  /// How many steps it takes to turn between two headings.
  [[nodiscard]] int turning_steps(double from_rad, double to_rad) const;

 private:
  [[nodiscard]] int view_at(const Pose2& pose);
  const ShortestPaths& paths_from(int place);

  Searcher searcher_;
  ActionSetOptions options_;
  Observability& observability_;
  MotionMap motion_;
  int lookout_count_ = 0;
  int prepared_ = 0;                       ///< lookouts, from the first
  std::vector<int> nodes_;                 ///< of motion_, per place
  std::vector<ShortestPaths> paths_;       ///< per place, empty until asked for
  std::vector<std::vector<int>> nearest_;  ///< per place
  std::map<std::pair<int, int>, Leg> legs_;
  std::map<std::pair<int, int>, int> view_of_;  ///< (standpoint, sector of heading) -> number
  std::deque<View> views_;                      ///< a deque: views stay where they are
  std::vector<View> panoramas_;
};

}  // namespace tandem
