#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/team/change_estimate.hpp"
#include "services/planner/core/team/place_translation.hpp"
#include "services/planner/core/team/route_value.hpp"

namespace tandem {

struct RefinementOptions {
  double warmth = 0.012;     ///< at first, how much worse a move may be to be taken with 1/e, as a share of the value;
                             ///< less with long routes
  double coldness = 0.0001;  ///< the same at the end of a cycle
  int cycle = 20000;         ///< moves from warm to cold at first, fewer where there is little to change; then again
                             ///< from the best with twice as many
  int neighbours = 12;       ///< lookouts near a place that moves look at
  double far_legs = 0.25;    ///< how often a move may lead to lookouts that are not near, over those in between
};

/// Makes routes better by small moves: insert, remove, relocate, replace, swap, reverse, move a piece, swap tails;
/// taken by simulated annealing. Equal routes, options and random numbers give equal results.
///
/// Most moves are taken or not by a ChangeEstimate; what looks like the best after some moves is valued exactly.
/// Places up to a fixed goal stay as they are.
class Refinement {
 public:
  /// Both must outlive it.
  Refinement(const TeamGround& ground, RouteValue& value, const RefinementOptions& options);

  /// Starts from these routes.
  void restart(const Routes& routes, double value_s);
  /// Tries so many moves; gives whether the best routes became better.
  bool improve(int moves, Rng& rng);

  [[nodiscard]] const Routes& best() const { return best_; }
  [[nodiscard]] double best_s() const { return best_s_; }
  /// Whether the last cycles found nothing better: time to restart from something else.
  [[nodiscard]] bool is_stuck() const;
  /// How many changes of routes were judged so far.
  [[nodiscard]] std::int64_t judged() const { return judged_; }

 private:
  enum class Move { Insert, Remove, Relocate, Replace, Swap, Reverse, Piece, Tails };

  bool make_trial(Move move, Rng& rng);
  /// Makes the trial a walk over near legs; false if it is none and may not be made one.
  bool join(Rng& rng);
  /// Whether the trial's route of a member is a walk over near legs, as the current one is.
  [[nodiscard]] bool is_walk(std::size_t member) const;
  /// Warms up from the best so far.
  void begin_cycle();
  /// How much worse a move may be to be taken with 1/e, as a share of the value.
  [[nodiscard]] double warmth_now() const;
  /// Keeps the current routes, whose value is exact, if they are the best so far.
  void keep_best();
  /// Whether the trial has more places than the current routes.
  [[nodiscard]] bool is_longer() const;
  /// Goes on from these routes.
  void take(const Routes& routes, double value_s);
  /// Takes the trial or not; `u`: uniform in [0, 1).
  void judge(double temperature_s, double u);
  [[nodiscard]] std::size_t free_places(std::size_t member) const;
  [[nodiscard]] std::size_t position(std::size_t member, Rng& rng) const;
  [[nodiscard]] int neighbour(std::size_t member, int place, Rng& rng) const;
  /// A place of any route near `place` of `member`: its route and position; none: routes_.size().
  struct Spot {
    std::size_t member = 0;
    std::size_t position = 0;
  };
  [[nodiscard]] Spot spot_near(std::size_t member, int place, Rng& rng) const;
  bool translate(std::size_t from, std::size_t to, std::vector<int>& places) const;
  bool relocate(std::size_t a, std::size_t i, std::size_t length, Rng& rng);
  bool swap_tails(std::size_t a, std::size_t i, Rng& rng);

  const TeamGround* ground_;
  RouteValue* value_;
  RefinementOptions options_;
  std::optional<ChangeEstimate> estimate_;  ///< where it is nearly right
  int drifted_ = 0;                         ///< changes accepted by it since the last exact value
  PlaceTranslation translation_;
  Routes current_;
  Routes trial_;
  Routes best_;
  double current_s_ = 0.0;
  double best_s_ = 0.0;
  std::vector<std::size_t> fixed_;  ///< per member, places at the beginning of its route that stay
  std::vector<int> piece_;
  std::vector<int> other_piece_;
  double warmest_ = 0.0;        ///< when a cycle begins, without heat
  double heat_ = 1.0;           ///< of this cycle, times the warmth
  double best_before_s_ = 0.0;  ///< when this cycle began
  std::int64_t cycle_ = 0;      ///< moves of this one
  std::int64_t in_cycle_ = 0;   ///< of them made
  int fruitless_ = 0;           ///< cycles, the last ones
  std::int64_t judged_ = 0;
};

}  // namespace tandem
