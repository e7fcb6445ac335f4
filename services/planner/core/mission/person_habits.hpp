#pragma once

#include <optional>

#include "services/common/time.hpp"
#include "services/planner/core/motion/motion_map.hpp"
#include "services/planner/core/team/search_problem.hpp"

namespace tandem {

/// What a person has done with plans so far: how much they followed, and which way they are walking.
class PersonHabits {
 public:
  /// `trust_s`: a person who was never seen off a plan counts as having followed one for so long.
  explicit PersonHabits(double trust_s) : trust_s_(trust_s) {}

  /// They are at `point_in_map` [m].
  void seen(Time now, const Eigen::Vector2d& point_in_map);
  /// Whether they are on the plan that holds; none if nobody can tell.
  void follow(Time now, std::optional<bool> on_plan);

  /// That they will not follow the next plan either: the share of time off plans, of all judged time and the trust.
  [[nodiscard]] double stray_probability() const { return off_plan_s_ / (off_plan_s_ + on_plan_s_ + trust_s_); }
  /// The direction they have walked in for the last seconds, of length 1; none if they stand.
  [[nodiscard]] std::optional<Eigen::Vector2d> course() const;

 private:
  struct Place {
    Time stamp{};
    Eigen::Vector2d point_in_map;
  };
  double trust_s_;
  double on_plan_s_ = 0.0;
  double off_plan_s_ = 0.0;
  std::optional<Time> judged_;
  std::optional<Place> earlier_;
  std::optional<Place> middle_;
  std::optional<Place> newest_;
};

/// Straight on from `from` at `speed_mps` until a body with `radius_m` no longer fits, but for no longer than
/// `longest_s`; then they wait. Without a course they wait at once.
[[nodiscard]] TimedPath straight_on(const MotionMap& motion, const Eigen::Vector2d& from,
                                    const std::optional<Eigen::Vector2d>& course, double speed_mps, double radius_m,
                                    double longest_s);

/// `path`, and a wait at its end until `end_s`.
[[nodiscard]] TimedPath waiting_until(TimedPath path, double end_s);

/// What is left of `path` for one who is at `now_in_map`, though it says where one is at `now_s`; times from now.
[[nodiscard]] TimedPath rest_of(const TimedPath& path, double now_s, const Eigen::Vector2d& now_in_map);

}  // namespace tandem
