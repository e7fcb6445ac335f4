#include "services/planner/core/mission/person_habits.hpp"

#include <algorithm>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kCourse_s = 3.0;      ///< a course is the way of so long, or up to twice that
constexpr double kLongestGap_s = 1.0;  ///< longer than this between two judgements nobody watched
constexpr double kStands_mps = 0.2;    ///< slower than this is standing
constexpr double kStep_m = 0.25;

}  // namespace

void PersonHabits::seen(Time now, const Vector2d& point_in_map) {
  if (newest_ && now <= newest_->stamp) return;
  newest_ = Place{now, point_in_map};
  if (!middle_ || to_seconds(now - middle_->stamp) >= kCourse_s) {
    earlier_ = middle_ ? middle_ : newest_;
    middle_ = newest_;
  }
}

void PersonHabits::follow(Time now, std::optional<bool> on_plan) {
  if (judged_ && on_plan) {
    const double since_s = std::clamp(to_seconds(now - *judged_), 0.0, kLongestGap_s);
    (*on_plan ? on_plan_s_ : off_plan_s_) += since_s;
  }
  judged_ = now;
}

std::optional<Vector2d> PersonHabits::course() const {
  if (!newest_ || !earlier_) return std::nullopt;
  const double since_s = to_seconds(newest_->stamp - earlier_->stamp);
  const Vector2d walked = newest_->point_in_map - earlier_->point_in_map;
  if (since_s <= 0.0 || walked.norm() < kStands_mps * since_s) return std::nullopt;
  return walked.normalized();
}

TimedPath straight_on(const MotionMap& motion, const Vector2d& from, const std::optional<Vector2d>& course,
                      double speed_mps, double radius_m, double longest_s) {
  TimedPath path{{{0.0, from}}};
  if (!course) return path;
  double reach_m = 0.0;
  while (reach_m + kStep_m <= speed_mps * longest_s &&
         motion.clearance_m(from, from + (reach_m + kStep_m) * *course) >= radius_m) {
    reach_m += kStep_m;
  }
  if (reach_m > 0.0) path.points.push_back({reach_m / speed_mps, from + reach_m * *course});
  return path;
}

TimedPath waiting_until(TimedPath path, double end_s) {
  if (path.duration_s() < end_s) path.points.push_back({end_s, path.points.back().point_in_map});
  return path;
}

TimedPath rest_of(const TimedPath& path, double now_s, const Vector2d& now_in_map) {
  TimedPath rest{{{0.0, now_in_map}}};
  for (const TimedPoint& point : path.points) {
    if (point.time_s > now_s) rest.points.push_back({point.time_s - now_s, point.point_in_map});
  }
  return rest;
}

}  // namespace tandem
