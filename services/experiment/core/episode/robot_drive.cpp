#include "services/experiment/core/episode/robot_drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/mapping/core/ray_casting.hpp"
#include "services/simulator/core/laser_view.hpp"

namespace tandem::experiment {
namespace {

constexpr int kBeams = 90;            ///< all around: 4 degrees apart
constexpr double kScanRange_m = 2.5;  ///< farther than the navigator looks ahead
constexpr double kPeopleRange_m = 6.0;
constexpr double kHeld_s = 0.5;
constexpr double kNear_m = 0.15;  ///< what the safety gate keeps ahead of the hull
constexpr double kMoves_m = 1e-3;

}  // namespace

RobotDrive::RobotDrive(const navigator::NavigatorConfig& config, const simulator::SlipModel& slip, const Pose2& start,
                       Rng rng)
    : period_s_(config.period_s),
      hull_{config.hull_length_m, config.hull_width_m},
      navigator_(config),
      body_(hull_, slip, start, rng) {}

void RobotDrive::step(Time now, const std::string& session, bool may_move, const simulator::Place& place,
                      std::span<const Bystander> people) {
  const navigator::Decision decision = navigator_.decide(situation(now, session, place, people));
  velocity_ = decision.velocity;
  execution_ = decision.execution;
  std::vector<simulator::Disc> bodies;
  for (const auto& person : people) bodies.push_back(person.body);
  const Eigen::Vector2d before = map_from_base().position();
  const Pose2 wheels = simulator::arc({velocity_.forward_mps, velocity_.turn_rate_radps}, period_s_);
  if (body_.move(wheels, place, bodies).blocked) velocity_ = {};
  count(may_move, (map_from_base().position() - before).norm(), people);
}

navigator::Situation RobotDrive::situation(Time now, const std::string& session, const simulator::Place& place,
                                           std::span<const Bystander> people) const {
  navigator::Situation known;
  known.now = now;
  known.running_session = session;
  known.pose = navigator::LocatedPose{map_from_base(), navigator::PoseQuality::Good, now, now};
  known.velocity = velocity_;
  const Eigen::Vector2d here = map_from_base().position();
  navigator::ScanHits hits;
  hits.stamp = hits.received = now;
  for (int i = 0; i < kBeams; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kBeams;
    const double heading_rad = map_from_base().heading + angle_rad;
    double range_m = range_to_obstacle_m(place.map(), here, heading_rad, kScanRange_m)
                         .value_or(std::numeric_limits<double>::infinity());
    for (const auto& person : people) {
      range_m = std::min(range_m, simulator::range_to_disc_m(here, heading_rad, person.body));
    }
    if (range_m <= kScanRange_m) {
      hits.points_in_base.emplace_back(range_m * std::cos(angle_rad), range_m * std::sin(angle_rad));
    }
  }
  known.obstacles = std::move(hits);
  for (const auto& person : people) {
    const Eigen::Vector2d& there = person.body.centre_in_map;
    if ((there - here).norm() > kPeopleRange_m || !line_of_sight(place.map(), here, there)) continue;
    known.people.push_back({there, person.velocity_in_map_mps});
  }
  return known;
}

void RobotDrive::count(bool may_move, double moved_m, std::span<const Bystander> people) {
  tally_.collisions = body_.collisions();
  tally_.distance_m += moved_m;
  const bool moves = velocity_ != Twist2{};

  const bool held = may_move && !moves && !execution_.finished;
  const double held_before_s = held_s_;
  held_s_ = held ? held_s_ + period_s_ : 0.0;
  if (held_before_s < kHeld_s && held_s_ >= kHeld_s) ++tally_.stops;

  idle_s_ = moves ? 0.0 : idle_s_ + period_s_;
  tally_.longest_idle_s = std::max(tally_.longest_idle_s, idle_s_);

  const navigator::Hull hull{hull_.length_m, hull_.width_m};
  const bool was_near = near_;
  near_ = std::ranges::any_of(people, [&](const Bystander& person) {
    const Eigen::Vector2d in_base = inverse(map_from_base()) * person.body.centre_in_map;
    return navigator::distance_to(hull, in_base) - person.body.radius_m < kNear_m;
  });
  if (near_ && !was_near && moved_m > kMoves_m) ++tally_.near_collisions;
}

}  // namespace tandem::experiment
