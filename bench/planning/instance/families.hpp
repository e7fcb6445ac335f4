#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bench/planning/instance/floor_plan.hpp"
#include "bench/planning/instance/prior.hpp"
#include "services/common/pose2.hpp"
#include "services/planner/core/search/search_area.hpp"
#include "services/planner/core/search/searcher.hpp"

namespace tandem::bench {

/// What changes in the world while it is searched (S6).
struct WorldEvent {
  enum class Kind { BlockedPassage, Hint, RejectedPlan, Passer };
  Kind kind = Kind::Hint;  ///< a passer lets everybody within its radius wait
  double time_s = 0.0;
  Eigen::Vector2d centre_in_map = Eigen::Vector2d::Zero();  ///< [m]
  double radius_m = 0.0;
  double factor = 1.0;  ///< of a hint: so many times likelier there
};

/// A search to be planned, whole: equal family and seed, equal instance, on every machine.
struct PlanningInstance {
  std::string family;
  std::uint64_t seed = 0;
  FloorPlan plan;
  double drone_altitude_m = 0.0;  ///< 0: nobody flies
  SearchAreaOptions area;
  std::vector<Searcher> searchers;
  std::vector<Pose2> starts;
  PriorSpec prior;
  double horizon_s = 0.0;         ///< The search is over after this time, whatever is left.
  double replan_period_s = 10.0;  ///< A plan is at the latest so old.
  std::string human;              ///< Policy of the first person; empty: walks its path to the letter.
  std::vector<WorldEvent> events;
};

/// A family of instances.
struct FamilySpec {
  std::string_view name;
  std::string_view what;
  bool quick = false;  ///< part of a quick run
};

[[nodiscard]] const std::vector<FamilySpec>& families();

/// Instance number `seed` of a family; throws ConfigError, naming the families, if there is none of that name.
[[nodiscard]] PlanningInstance instance_of(std::string_view family, std::uint64_t seed);

/// The number of the first person among the searchers; as many as there are if there is none.
[[nodiscard]] std::size_t person_of(const PlanningInstance& instance);

/// The maps searched in: the ground and, if someone flies, the layer above low walls.
[[nodiscard]] std::vector<OccupancyGrid> layers_of(const PlanningInstance& instance);

}  // namespace tandem::bench
