#pragma once

#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/team/place_translation.hpp"
#include "services/planner/core/team/route_value.hpp"

namespace tandem {

struct RefinementOptions {
  double warmth = 0.004;     ///< at first, how much worse a move may be to be taken with 1/e, as a share of the value
  double coldness = 0.0002;  ///< the same at the end of a cycle
  int cycle = 6000;          ///< moves from warm to cold; then again from the best
  int neighbours = 8;        ///< lookouts near a place that moves look at
  double far_legs = 0.02;    ///< how often a move may ask for legs to lookouts that are not near, which takes time
};

/// Makes routes better by small moves: insert, remove, relocate, replace, swap, reverse, move a piece, swap tails;
/// taken by simulated annealing. Equal routes, options and random numbers give equal results.
///
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

 private:
  enum class Move { Insert, Remove, Relocate, Replace, Swap, Reverse, Piece, Tails };

  bool make_trial(Move move, Rng& rng);
  /// Whether the trial goes only to lookouts near to where it comes from, but for what it shares with the current
  /// routes. (What is known already would depend on what was planned before.)
  [[nodiscard]] bool stays_near() const;
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
  PlaceTranslation translation_;
  Routes current_;
  Routes trial_;
  Routes best_;
  double current_s_ = 0.0;
  double best_s_ = 0.0;
  std::vector<std::size_t> fixed_;  ///< per member, places at the beginning of its route that stay
  std::vector<int> piece_;
  std::vector<int> other_piece_;
  int moves_ = 0;
};

}  // namespace tandem
