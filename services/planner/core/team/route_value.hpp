#pragma once

#include <vector>

#include "services/planner/core/team/team_ground.hpp"

namespace tandem {

/// The expected time of routes, fast enough to compare a hundred thousand a second: the inner reading of
/// SearchObjective, for the routes of one problem.
///
/// Equal to it, but for single precision, where all find what they see. With finite detection rates a look of one agent
/// at a cell is taken as whole before another's that began later: exact where two do not look at one cell at once. With
/// several objects it asks SearchObjective itself. Allocates nothing once warm.
class RouteValue {
 public:
  /// `ground` must outlive it.
  explicit RouteValue(const TeamGround& ground);

  /// Expected time [s], with hypotheses about who may not follow and the penalty of rejected plans.
  [[nodiscard]] double value_s(const Routes& routes);
  /// The same by SearchObjective itself.
  [[nodiscard]] double exact_s(const Routes& routes);

 private:
  /// A course of events: all follow the plan, or one does something else.
  struct Course {
    double weight = 1.0;
    int astray = -1;                ///< the member that does not follow
    std::vector<Look> fixed_looks;  ///< what is looked at whatever the routes
    std::vector<float> first_s;     ///< per cell: when fixed looks see it (first sight)
  };
  /// How far the walk along one route is.
  struct Cursor {
    std::size_t next = 0;
    int place = -1;
    double time_s = 0.0;
    float heading_rad = 0.0F;
    const std::vector<std::int32_t>* view = nullptr;  ///< what it has in view where it stands
  };

  void add_course(double weight, int astray, const PathHypothesis* hypothesis);
  [[nodiscard]] double first_sight_s(const Course& course, const Routes& routes);
  [[nodiscard]] double with_rates_s(const Course& course, const Routes& routes);
  void look(std::int32_t cell, double from_s, float kept, float rate_inverse_s, double to_s);
  [[nodiscard]] bool is_rejected(const Routes& routes) const;

  const TeamGround* ground_;
  const SearchProblem* search_;
  float end_s_ = 0.0F;  ///< horizon and tail
  double total_ = 0.0;  ///< mass
  double saved_ = 0.0;  ///< mass times time, against never looking
  std::vector<Course> courses_;
  std::deque<Sightings> hypothesis_seen_;
  std::vector<float> first_s_;
  std::vector<float> left_;  ///< per cell, share of its mass
  std::vector<Cursor> cursors_;
  SearchObjective objective_;
  std::vector<Look> looks_;
};

}  // namespace tandem
