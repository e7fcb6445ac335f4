#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "services/common/random.hpp"
#include "services/navigator/core/navigator.hpp"

namespace tandem::navigator {

struct Wall {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// The four walls of a box.
inline std::vector<Wall> box(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}},
          {{right, bottom}, {right, top}},
          {{right, top}, {left, top}},
          {{left, top}, {left, bottom}}};
}

/// A robot that does what it is told within its accelerations and the rules of the safety gate, in a world of walls.
class Drive {
 public:
  Drive(const NavigatorConfig& config, std::vector<Wall> walls, Pose2 start, LinkLoss link_loss = LinkLoss::Stop,
        std::vector<MapArea> zones = {})
      : config_(config),
        navigator_(config, link_loss, Zones{std::move(zones)}),
        walls_(std::move(walls)),
        pose_(start) {}

  /// Accepts a plan with these points and keeps it alive from now on.
  void accept(std::vector<Eigen::Vector2d> points, const std::string& id = "plan1") {
    plan_ = {id, "S1", "planner@laptop", 0, PlanState::Accepted, now_ + from_seconds(1000.0), std::move(points)};
    navigator_.receive_plan(numbered(), now_);  // heard once before
    next_refresh_ = now_;
  }

  Decision step() {
    if (refreshing && now_ >= next_refresh_) {
      navigator_.receive_plan(numbered(), now_);
      if (second_planner) {
        PlanNews other = plan_;
        other.planner = "planner@elsewhere";
        navigator_.receive_plan(std::move(other), now_);
      }
      next_refresh_ = now_ + from_seconds(1.0);
    }
    seen_ = hits();
    if (tick_ % 2 == 0) scan_ = {seen_, now_, now_};  // 10 Hz
    ++tick_;
    Situation situation;
    situation.now = now_;
    situation.running_session = "S1";
    if (localized) situation.pose = LocatedPose{pose_, quality, now_, now_};
    if (scanning) situation.obstacles = scan_;
    situation.velocity = velocity_;
    situation.base = base;
    situation.link_lost = link_lost;
    const Decision decision = navigator_.decide(situation);
    move(decision.velocity);
    return decision;
  }

  /// Steps until `done` says true; false after `limit_s`.
  template <typename Done>
  bool drive_until(double limit_s, Done done) {
    const Time end = now_ + from_seconds(limit_s);
    while (now_ < end) {
      if (done(step())) return true;
    }
    return false;
  }
  bool drive_to_goal(double limit_s) {
    return drive_until(limit_s, [](const Decision& decision) { return decision.execution.finished; });
  }

  [[nodiscard]] Time now() const { return now_; }
  [[nodiscard]] const Pose2& pose() const { return pose_; }
  [[nodiscard]] const Twist2& velocity() const { return velocity_; }
  [[nodiscard]] double least_clearance_m() const { return least_clearance_m_; }
  std::vector<Wall>& walls() { return walls_; }

  bool refreshing = true;
  bool second_planner = false;  ///< publishes a plan as well, and as often
  bool link_lost = false;
  bool localized = true;
  bool scanning = true;
  PoseQuality quality = PoseQuality::Good;
  BaseReport base;

 private:
  PlanNews numbered() {
    ++plan_.sequence_number;
    return plan_;
  }

  /// What 361 beams over 270 degrees hit, in the base frame; the laser is 0.16 m ahead of the base's centre.
  [[nodiscard]] std::vector<Eigen::Vector2d> hits() const {
    const Pose2 base_from_laser{0.16, 0.0, 0.0};
    const Pose2 map_from_laser = pose_ * base_from_laser;
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 361; ++i) {
      const double bearing = from_degrees(-135.0 + 0.75 * i);
      const Eigen::Vector2d ray{std::cos(map_from_laser.heading + bearing), std::sin(map_from_laser.heading + bearing)};
      double range = 30.0;
      for (const auto& wall : walls_) {
        const Eigen::Vector2d along = wall.to - wall.from;
        const Eigen::Vector2d offset = wall.from - map_from_laser.position();
        const double cross = ray.x() * along.y() - ray.y() * along.x();
        if (std::abs(cross) < 1e-12) continue;
        const double distance = (offset.x() * along.y() - offset.y() * along.x()) / cross;
        const double share = (offset.x() * ray.y() - offset.y() * ray.x()) / cross;
        if (distance > 0.0 && share >= 0.0 && share <= 1.0) range = std::min(range, distance);
      }
      if (range < 30.0) {
        points.push_back(base_from_laser * Eigen::Vector2d{range * std::cos(bearing), range * std::sin(bearing)});
      }
    }
    return points;
  }

  /// The rules of faults.md that the gate enforces, in short.
  [[nodiscard]] Twist2 gated(Twist2 wanted) const {
    const Hull hull{config_.hull_length_m, config_.hull_width_m};
    const auto& points = seen_;
    if (std::abs(wanted.forward_mps) < 1e-3) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& point : points) nearest = std::min(nearest, point.norm());
      if (nearest < hull.circumscribed_radius_m() + 0.1) return {};
      if (nearest < hull.circumscribed_radius_m() + 0.6) {
        wanted.turn_rate_radps = std::clamp(wanted.turn_rate_radps, -0.5, 0.5);
      }
      return wanted;
    }
    const double curvature = wanted.turn_rate_radps / wanted.forward_mps;
    const double free_m = free_way(hull, 0.0, curvature, points).way_m;
    const double allowed = speed_that_stops_within(free_m - 0.15, 0.5, 0.6);
    const double share = std::min(1.0, allowed / wanted.forward_mps);
    return {wanted.forward_mps * share, 0.0, wanted.turn_rate_radps * share};
  }

  void move(const Twist2& command) {
    const double dt = config_.period_s;
    const Twist2 wanted = base.stopped_by.empty() ? gated(command) : Twist2{};
    const auto towards = [&](double from, double to, double up, double down) {
      return to > from ? std::min(to, from + up * dt) : std::max(to, from - down * dt);
    };
    velocity_.forward_mps = towards(velocity_.forward_mps, wanted.forward_mps, 0.3, 0.6);
    velocity_.turn_rate_radps = towards(velocity_.turn_rate_radps, wanted.turn_rate_radps, 2.0, 2.0);
    pose_ = moved_on(pose_, velocity_, dt);
    now_ += from_seconds(dt);
    const Hull hull{config_.hull_length_m, config_.hull_width_m};
    for (const auto& point : seen_) {  // where they have come to with this step, as far as the laser saw them
      const Eigen::Vector2d now_in_base = inverse(moved_on({}, velocity_, dt)) * point;
      least_clearance_m_ = std::min(least_clearance_m_, distance_to(hull, now_in_base));
    }
  }

  NavigatorConfig config_;
  Navigator navigator_;
  std::vector<Wall> walls_;
  Pose2 pose_;
  Twist2 velocity_;
  Time now_ = from_stamp_ns(1'000'000'000'000);
  Time next_refresh_{};
  PlanNews plan_;
  std::vector<Eigen::Vector2d> seen_;
  ScanHits scan_;
  int tick_ = 0;
  double least_clearance_m_ = std::numeric_limits<double>::infinity();
};

}  // namespace tandem::navigator
