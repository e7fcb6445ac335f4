#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planner/core/team/team_ground.hpp"

namespace tandem {

/// Something a member can do next.
struct Choice {
  int place = -1;      ///< -1: wait until the end
  float score = 0.0F;  ///< gain per time^exponent
  float gain = 0.0F;   ///< the mass it shows that nobody has promised to look at yet
};

/// How a walk appraises what a member can do next.
struct WalkOptions {
  double exponent = 1.5;  ///< of time in a score; 1.5 measured best for greedy plans
  int far_lookouts = 2;   ///< looked at once the neighbourhood is done
};

/// A joint plan in the making: who is under way to where, until when, and what mass is not yet promised to be seen.
///
/// Time is asynchronous (digest F5-F7): the next to choose is whoever arrives first, the others are still under way.
/// Two who arrive at the same moment choose one after the other, which spans the same joint states as choosing at once.
class JointWalk {
 public:
  JointWalk(const TeamGround& ground, const WalkOptions& options);

  /// Back to the beginning.
  void restart();
  /// Who chooses next, -1 once all are at the end. With `only`, nobody else ever chooses.
  [[nodiscard]] int next_member(int only = -1) const;
  /// The best things `member` can do next, best first, at most `count`; never empty. Valid until the next call.
  [[nodiscard]] std::span<const Choice> choices(int member, int count);
  /// The member goes there, over lookouts in between if it is far; -1: it waits until the end.
  void choose(int member, int place);

  [[nodiscard]] const Routes& routes() const { return routes_; }
  [[nodiscard]] float mass_left() const { return mass_left_; }

 private:
  struct Progress {
    int place = -1;
    double busy_until_s = 0.0;
    float heading_rad = 0.0F;
    bool goal_ahead = false;
    double detour_left_m = 0.0;  ///< how far it may still walk to the goal
  };
  [[nodiscard]] Choice scored(int place, float gain, double time_s) const;
  /// Of a place near to the member.
  [[nodiscard]] Choice appraised(int member, int place);
  /// Of any place.
  [[nodiscard]] Choice appraised_far(int member, int place);
  /// Until its battery is empty, or the horizon.
  [[nodiscard]] double time_left_s(int member) const;
  [[nodiscard]] double leg_time_s(int member, const CompactLeg& leg) const;
  void add_far_lookouts(int member);
  [[nodiscard]] float in_view_of(ActionSet& actions, int lookout) const;
  void go(int member, int place);

  const TeamGround* ground_;
  WalkOptions options_;
  std::vector<Progress> beginnings_;
  std::vector<Progress> members_;
  std::vector<float> mass_;  ///< not yet promised
  float mass_left_ = 0.0F;
  float total_ = 0.0F;      ///< mass
  float best_view_ = 0.0F;  ///< the most mass that one lookout has in view
  Routes routes_;
  std::vector<Choice> choices_;
  std::vector<Choice> guesses_;
  std::vector<std::uint32_t> counted_;  ///< per cell, the last appraisal that counted it
  std::uint32_t appraisal_ = 0;
};

}  // namespace tandem
