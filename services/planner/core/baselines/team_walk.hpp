#pragma once

#include <vector>

#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// A place a member could go to next.
struct WalkOption {
  int place = -1;
  double gain = 0.0;    ///< mass it shows on the way there, while it can go on, that nobody has shown yet
  double time_s = 0.0;  ///< until it is there, the turn at the beginning included
};

/// A plan that the baselines make step by step: whoever arrives first chooses the next place.
///
/// Kept apart from the course of the team planner, so that the baselines stay what they are when that one is tuned.
class TeamWalk {
 public:
  /// At most so many options are offered, the nearest ones: `most_options`. `problem` outlives the walk.
  TeamWalk(const PreparedProblem& problem, int most_options);

  /// Who chooses next: whoever is there first; -1 once nobody has time left.
  [[nodiscard]] int next_member() const;
  /// The nearest lookouts that show something new, nearest first. With a fixed goal ahead: only those on ways at most
  /// half as long again as the shortest and 4 m, and the goal itself as the last one.
  [[nodiscard]] std::vector<WalkOption> options(int member) const;
  /// Any one of them.
  [[nodiscard]] WalkOption option(int member, int place) const;
  /// The member goes there: what it sees is no longer new to anybody. It stays where no way leads there.
  void go(int member, int place);
  /// The member stays where it is for the rest of the time.
  void stay(int member);

  [[nodiscard]] const Routes& routes() const { return routes_; }
  /// What is new yet, of all objects, per search cell.
  [[nodiscard]] const std::vector<double>& mass() const { return mass_; }
  /// What a lookout of `member` shows to all sides and is new [mass].
  [[nodiscard]] double mass_around(int member, int lookout) const;
  /// Whether so much mass is worth a look: more than rounding leaves, by the mass that there was in all.
  [[nodiscard]] bool counts(double mass) const { return mass > nothing_; }
  [[nodiscard]] int place_of(int member) const { return progress_[static_cast<std::size_t>(member)].place; }

 private:
  struct Progress {
    int place = -1;
    double busy_until_s = 0.0;
    double heading_rad = 0.0;
    bool goal_ahead = false;
    double detour_left_m = 0.0;
  };
  [[nodiscard]] const PreparedProblem::Member& member_at(int member) const {
    return problem_->members()[static_cast<std::size_t>(member)];
  }
  void take_in(const Sightings& seen, double rate_per_s, double until_s);

  const PreparedProblem* problem_;
  int most_options_;
  std::vector<double> mass_;
  double nothing_ = 0.0;  ///< mass
  std::vector<Progress> progress_;
  Routes routes_;
};

/// Lets everybody but `member` follow their `routes`, and `member` go where `choose` says (-1: it stays), in the order
/// in which they arrive: what the others are on their way to see when `member` chooses is not new to it, what they will
/// see later is.
template <typename Choose>
void walk_among(TeamWalk& walk, const Routes& routes, int member, const Choose& choose) {
  std::vector<std::size_t> next(routes.size(), 0);
  for (int who = walk.next_member(); who >= 0; who = walk.next_member()) {
    const auto m = static_cast<std::size_t>(who);
    const int place = who == member ? choose() : next[m] < routes[m].size() ? routes[m][next[m]++] : -1;
    place < 0 ? walk.stay(who) : walk.go(who, place);
  }
}

}  // namespace tandem
