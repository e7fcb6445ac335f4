#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "services/planner/core/team/sight_times.hpp"
#include "services/planner/core/team/team_ground.hpp"

namespace tandem {

/// What small changes of routes are worth, from who is the first and who would be the second to show each cell: in time
/// proportional to the change, not to the routes.
///
/// Nearly right: legs behind a change are taken to be shifted in time as a whole and to stay the first to show what
/// they show. So what is accepted change by change drifts off the exact value, which rebase() makes good. Only where
/// all find what they see and no battery is empty before the horizon; allocates nothing once warm.
class ChangeEstimate {
 public:
  /// `ground` must outlive it.
  explicit ChangeEstimate(const TeamGround& ground);

  /// Starts from these routes, walks over near legs.
  void rebase(const Routes& routes);
  /// How much later [s] the object is expected to be found with `trial` than with the routes so far; none if the change
  /// is not a small one.
  [[nodiscard]] std::optional<double> change_s(const Routes& trial);
  /// The share of the mass that the changed legs of the last change_s(), and those behind them, are the first to show.
  [[nodiscard]] double share_at_stake() const { return at_stake_ / total_; }
  /// Makes the trial of the last change_s(), a small one, the routes so far.
  void accept(const Routes& trial);

 private:
  /// A leg of the routes.
  struct Visit {
    const CompactLeg* leg = nullptr;
    double first_mass = 0.0;  ///< that it is the first to show
    double later_mass = 0.0;  ///< that it and those behind it are the first to show
  };
  struct Seen {
    std::int32_t visit;
    float enter_s;  ///< from its start
  };
  /// A member's legs `first` .. `last` - 1 are replaced by those to the places `from` .. `to` - 1 of the trial.
  struct Change {
    std::size_t member;
    std::size_t first;
    std::size_t last;
    std::size_t from;
    std::size_t to;
    std::size_t new_leg;  ///< the first of them in new_legs_
    double start_s;       ///< when the first leg begins
    double delay_s;       ///< of what comes behind
  };

  /// When a visit shows a cell; what it shows at the horizon or later it never shows.
  [[nodiscard]] float time_s(const Seen& seen) const {
    const float at_s = start_s_[static_cast<std::size_t>(seen.visit)] + seen.enter_s;
    return at_s < horizon_s_ ? at_s : end_s_;
  }
  [[nodiscard]] std::int32_t add_visit(const CompactLeg& leg, double start_s);
  /// Finds who is first and second to show a cell.
  void sort_out(std::size_t cell);
  /// The same, if only this one came.
  void sort_in(std::size_t cell, const Seen& seen);
  /// Moves what a visit shows to its new start.
  void shift(std::int32_t visit);
  void sum_up();
  [[nodiscard]] bool find_change(std::size_t member, const std::vector<int>& trial);
  /// Finds the legs of a change and has the processor load them, all before the first is needed.
  void fetch(Change& change, const std::vector<int>& trial);
  /// Takes the old legs of a change out: how much later that is [s], times the mass.
  [[nodiscard]] double later_without(const Change& change);
  /// Puts the new ones in: how much sooner that is [s], times the mass. Finds when they begin and end, too.
  [[nodiscard]] double sooner_with(Change& change);
  void replace_visits(const Change& change);

  const TeamGround* ground_;
  float end_s_ = 0.0F;
  float horizon_s_ = 0.0F;
  double total_ = 0.0;
  std::vector<float> fixed_first_s_;  ///< per cell, when it is seen whatever the routes
  Routes base_;
  std::vector<std::vector<std::int32_t>> legs_;  ///< per member its visits
  std::vector<Visit> visits_;                    ///< of the routes, and free ones
  std::vector<float> start_s_;                   ///< per visit
  std::vector<std::int32_t> free_;               ///< visits
  std::vector<std::vector<Seen>> seen_;          ///< per cell by whom
  SightTimes times_;
  Overwritten overwritten_;                  ///< of times_, while a trial is judged
  std::vector<Change> changes_;              ///< of the last trial
  std::vector<const CompactLeg*> new_legs_;  ///< of the last trial
  double at_stake_ = 0.0;
  std::vector<std::uint32_t> touched_in_;  ///< per cell, the last pass that touched it
  std::uint32_t pass_ = 0;
  std::vector<std::size_t> touched_;      ///< cells of which who was first or second is gone
  std::vector<std::int32_t> new_visits_;  ///< of the change that is being accepted
};

}  // namespace tandem
