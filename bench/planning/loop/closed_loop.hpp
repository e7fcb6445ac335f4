#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/planning/instance/families.hpp"
#include "bench/planning/loop/score.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem::bench {

/// How much may be computed for one plan: processor time, or a number of rollouts if `rollouts` is set.
struct PlanningBudget {
  double cpu_ms = 200.0;
  std::optional<int> rollouts = std::nullopt;
};

inline constexpr double kPlanHorizonSweeps = 2.5;  ///< plans are compared over the time of so many sweeps of the area

/// Makes a planner; a new one for each search.
using MakePlanner = std::function<std::unique_ptr<Planner>()>;

/// What the robots make of a person with a will of their own.
enum class PersonIs {
  Planned,  ///< a member of the team, who gets a plan and may follow it
  Known,    ///< on a way that is known to its end: what a clairvoyant robot would plan with
  Ignored,  ///< not there: their looks count, but no robot hears of them
};

struct LoopOptions {
  PlanningBudget budget;
  std::uint64_t seed = 1;    ///< of the planner
  bool shares_looks = true;  ///< Otherwise each plans alone and knows only what it saw itself.
  PersonIs person = PersonIs::Planned;
  /// The whole way of the person if it is Known or Ignored.
  TimedPath person_path = {};
};

/// A whole search with a planner in the loop, and how it went.
struct LoopResult {
  SearchScore score;
  bool finished = false;  ///< all was seen before the horizon
  double duration_s = 0.0;
  double prepare_ms = 0.0;  ///< processor time for the map, before the first plan
  double first_plan_ms = 0.0;
  std::vector<double> replan_ms;  ///< all plans, the first one too
  double first_value_s = 0.0;     ///< what the first plan promised
  double first_bound_s = 0.0;     ///< its certified lower bound, 0 if none
  double sweep_bound_s = 0.0;     ///< sweep_lower_bound_s() of the instance
  int rollouts = 0;               ///< of all plans
  int fallbacks = 0;              ///< stretches walked to the nearest unseen, as plans promised or showed nothing new
  int repeated = 0;               ///< plans that were like one that had been rejected
  double plan_change_m = 0.0;     ///< how far a new plan leads from the old one within 30 s, mean over replans
  std::vector<Walked> walked;
};

/// Plays the search of `instance`: everybody walks the plan to the letter; it is planned anew when a path ends, at the
/// latest after the instance's replan period, and when the world changes. Equal arguments and a budget of rollouts give
/// an equal result, bit for bit.
[[nodiscard]] LoopResult played(const PlanningInstance& instance, const MakePlanner& make_planner,
                                const LoopOptions& options);

}  // namespace tandem::bench
