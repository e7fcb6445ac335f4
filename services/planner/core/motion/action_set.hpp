#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "services/planner/core/motion/lookouts.hpp"
#include "services/planner/core/motion/road_graph.hpp"
#include "services/planner/core/motion/timed_path.hpp"
#include "services/planner/core/search/sightings.hpp"

namespace tandem {

/// An action: going from one place of an action set to another, and what is seen on the way.
struct Leg {
  std::vector<Eigen::Vector2d> way;  ///< [m]; empty: no way leads there
  double initial_heading_rad = 0.0;
  double final_heading_rad = 0.0;
  double duration_s = 0.0;  ///< turns at corners included, the turn at its beginning not
  Sightings seen;           ///< from its beginning
  /// What is in view at its end, while the agent turns to the next leg; empty if it need not turn.
  Sightings stay;

  [[nodiscard]] bool possible() const { return !way.empty(); }
};

struct ActionSetOptions {
  double lookout_range_m = 2.5;  ///< lookouts are so dense that all is seen from this near
  double least_gain_m2 = 1.0;
  int nearest = 14;  ///< lookouts looked at first from each place
};

/// What agents of one capability can do: go from lookout to lookout, sequences of which are their plans (digest E1,
/// E2).
///
/// A leg to a lookout that is not near is a chain of legs between near ones, so every plan is a walk over near legs:
/// what holds for these holds for all plans.
///
/// Places 0 .. lookouts() - 1 are the lookouts, which stay from plan to plan; starts and goals of one plan are added
/// behind them. Ways and what is seen on them are found when first asked for and kept.
class ActionSet {
 public:
  /// `map` and `views` must outlive it. `start_in_map` picks the part of the map the agents are in.
  ActionSet(const OccupancyGrid& map, ViewTable& views, const ActionSetOptions& options,
            const Eigen::Vector2d& start_in_map, const std::vector<BlockedDisc>& blocked = {});

  ActionSet(const ActionSet&) = delete;  // its parts point at each other
  ActionSet& operator=(const ActionSet&) = delete;

  /// Forgets the places added for the last plan.
  void forget_added_places();
  /// Adds a start or goal: the point itself, or where one can stand near it; none if that is not within `reach_m`.
  [[nodiscard]] std::optional<int> add_place(const Eigen::Vector2d& point_in_map, double reach_m);

  /// Whether an agent at that point gets anywhere.
  [[nodiscard]] bool can_stand_near(const Eigen::Vector2d& point_in_map) const;

  [[nodiscard]] int lookouts() const { return roads_.lookouts(); }
  [[nodiscard]] const Eigen::Vector2d& place(int index) const { return points_[static_cast<std::size_t>(index)]; }
  /// Whether a way leads from one place to the other.
  [[nodiscard]] bool is_connected(int from, int to) { return std::isfinite(distance_m(from, to)); }
  /// How far it is from one place to another, clearance counted [m].
  [[nodiscard]] double distance_m(int from, int to) { return roads_.cost_m(from, to); }
  /// An action; without a way if none leads there.
  [[nodiscard]] const Leg& leg(int from, int to);
  /// The walk over near legs from `from` to these places one after the other; those that cannot be reached are left
  /// out.
  [[nodiscard]] std::vector<int> joined(int from, std::span<const int> places);
  /// Calls `reached` with lookouts in the order of their distance from a place, until it gives false.
  void explore(int from, const std::function<bool(int lookout, double distance_m)>& reached) {
    roads_.explore(from, reached);
  }
  /// Whether a leg needs no stop in between: one from a lookout to one of the nearest, one from or to an added place as
  /// far as four times as many lookouts, and one between added places.
  [[nodiscard]] bool is_near(int from, int to);
  /// All lookouts to which a leg from a place needs no stop, the nearest first.
  [[nodiscard]] std::vector<int> near_lookouts(int from);
  /// The lookouts nearest to a place, itself not among them: those worth looking at first.
  [[nodiscard]] const std::vector<int>& nearest_lookouts(int from);
  /// What a lookout shows to all sides, to guess what a far one is worth.
  [[nodiscard]] const View& panorama(int lookout);
  [[nodiscard]] const Searcher& searcher() const { return views_.searcher(); }
  [[nodiscard]] const MotionMap& motion() const { return motion_; }

 private:
  [[nodiscard]] std::vector<Eigen::Vector2d> way(int from, int to);

  ActionSetOptions options_;
  ViewTable& views_;
  MotionMap motion_;
  RoadGraph roads_;
  std::vector<Eigen::Vector2d> points_;            ///< per place [m]
  std::vector<std::vector<int>> nearest_;          ///< per place
  std::map<std::pair<int, int>, Leg> legs_;        ///< between lookouts
  std::map<std::pair<int, int>, Leg> added_legs_;  ///< from or to added places
  std::vector<View> panoramas_;
};

}  // namespace tandem
