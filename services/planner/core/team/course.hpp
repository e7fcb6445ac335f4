#pragma once

#include <vector>

#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// Something a member can do next.
struct Choice {
  int place = -1;      ///< -1: wait until the horizon
  double score = 0.0;  ///< gain per time^1.5
  double gain = 0.0;   ///< the mass it shows that nobody has promised to look at yet
};

/// A joint plan in the making: who is under way to where, until when, and what mass is not yet promised to be seen.
///
/// Time is asynchronous (digest F5-F7): the next to choose is whoever arrives first, the others are still under way.
/// Two who arrive at the same moment choose one after the other, which spans the same joint states as choosing at once.
class Course {
 public:
  explicit Course(const PreparedProblem& problem);

  /// Who chooses next, -1 once all are busy until the horizon.
  [[nodiscard]] int next_member() const;
  /// The best things `member` can do next, best first, at most `count`; never empty.
  [[nodiscard]] std::vector<Choice> choices(int member, int count) const;
  /// The member goes there.
  void choose(int member, int place);

  [[nodiscard]] const Routes& routes() const { return routes_; }

 private:
  struct Progress {
    int place = -1;
    double busy_until_s = 0.0;
    double heading_rad = 0.0;
    bool goal_ahead = false;
    double detour_left_m = 0.0;  ///< how far it may still walk to the goal
  };
  [[nodiscard]] Choice appraised(int member, int place) const;
  void promise(const Sightings& seen, double rate_per_s);
  void add_far_lookouts(int member, std::vector<Choice>& choices) const;

  const PreparedProblem* problem_;
  std::vector<Progress> members_;
  std::vector<double> mass_;  ///< not yet promised, of all objects
  double mass_left_ = 0.0;
  Routes routes_;
};

}  // namespace tandem
