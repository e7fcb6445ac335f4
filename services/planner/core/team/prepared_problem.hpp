#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "services/planner/core/team/search_problem.hpp"

namespace tandem {

/// The places each member goes to, one after the other.
using Routes = std::vector<std::vector<int>>;

/// A problem on the places of the members' action sets: what planners that choose places start from.
class PreparedProblem {
 public:
  struct Member {
    ActionSet* actions = nullptr;
    int start = -1;                   ///< the place where the plan begins: where `committed` ends
    double start_s = 0.0;             ///< and when
    double heading_rad = 0.0;         ///< and how it looks there
    double end_s = 0.0;               ///< when its battery is empty, or the horizon
    std::optional<int> goal;          ///< a place
    const Sightings* stay = nullptr;  ///< what is in view at the start
  };

  /// Adds starts and goals to the action sets; what was added for other problems is forgotten. `problem` must outlive
  /// it. A member that stands where it cannot move waits; a goal that cannot be reached is none.
  explicit PreparedProblem(const SearchProblem& problem);
  PreparedProblem(const PreparedProblem&) = delete;  // its looks point into it
  PreparedProblem& operator=(const PreparedProblem&) = delete;

  [[nodiscard]] const SearchProblem& problem() const { return problem_; }
  [[nodiscard]] const std::vector<Member>& members() const { return members_; }
  /// What is looked at whatever is planned: on committed paths and by others.
  [[nodiscard]] const std::vector<Look>& fixed_looks() const { return fixed_looks_; }
  /// What `member` sees on its way to these places until `end_s`, appended to `looks`. Impossible legs are left out.
  void add_looks(std::size_t member, const std::vector<int>& places, std::vector<Look>& looks) const;
  /// `committed`, then the way to these places, as far as the battery lasts; no more places than are reached by
  /// `until_s`.
  [[nodiscard]] TimedPath path(std::size_t member, const std::vector<int>& places,
                               double until_s = std::numeric_limits<double>::infinity()) const;
  /// The plan of these routes, with its value.
  [[nodiscard]] JointPlan plan(const Routes& routes) const;

 private:
  const SearchProblem& problem_;
  std::vector<Member> members_;
  std::deque<Sightings> fixed_seen_;
  std::vector<Look> fixed_looks_;
};

}  // namespace tandem
