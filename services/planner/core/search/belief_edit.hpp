#pragma once

#include <optional>
#include <string>

#include "services/planner/core/search/search_belief.hpp"
#include "services/planner/core/srs/reward_ratio.hpp"

namespace tandem {

/// What a person says of a part of the map.
struct BeliefEdit {
  enum class Kind {
    LikelyHere,  ///< the object is likelier here than elsewhere
    NotHere,     ///< the object is surely not here: likelier elsewhere
    Searched,    ///< they have looked here
    LookAgain,   ///< who looked here, or said it is not here, may have missed it
  };
  Kind kind = Kind::LikelyHere;
  PlanarShape region;
  /// A graded word of kStrengthWords; how they searched: "roughly" or "well". Empty: "quite", or "well".
  std::string strength;
  std::string who{};  ///< says so
};

/// By how much a hint of this strength [1/s, kStrengthWords] makes a region likelier, or the rest of the map: "a bit"
/// 2, "quite" 4, "very" 10 times.
[[nodiscard]] constexpr double hint_factor(double strength_per_s) {
  return 1.0 + 3.0 * strength_per_s;
}

/// The largest of them, and so what a wrong hint can cost: no cell keeps less than a tenth of its probability, and the
/// best plan for the edited belief finds the object in at most ten times the expected time of the best plan without the
/// hint. (Let a belief q lie between p / f1 and f2 p. A plan's expected time E_q then lies between E_p / f1 and f2 E_p,
/// so E_p of the best plan for q is at most f1 f2 times the best E_p; for one hint, f1 f2 is its factor. Hints in
/// several places that all are wrong cost at most the square.)
inline constexpr double kLargestHintFactor = hint_factor(kStrengthWords.back().per_s);

/// The exposure that "I searched this" counts for: roughly, half of all objects would have been found; well, 86 %. So a
/// wrong claim costs at most a factor of 2, or 7.4.
inline constexpr double kSearchedRoughly = 0.7;
inline constexpr double kSearchedWell = 2.0;

/// What "look again" restores is a share rho of the probability that is left then. If it was wrong, the best plan for
/// the edited belief takes in expectation at most rho / (1 - rho) times as much longer as the best plan without it
/// takes to look there: q = (1 - rho) p + rho r, so (1 - rho) E_p of the one is at most E_q of the other.

/// Changes the belief as `agent` says, or says why not. Whatever the edit, the posterior adds up to 1. Saying the same
/// again changes nothing.
[[nodiscard]] std::optional<std::string> edit_belief(SearchBelief& belief, const SearchArea& area,
                                                     const BeliefEdit& edit, std::size_t agent);

}  // namespace tandem
