#include "services/simulator/core/walker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "services/simulator/core/scenario.hpp"

namespace tandem::simulator {
namespace {

constexpr double kArrived_m = 0.15;
constexpr double kLookAhead_m = 0.4;
constexpr double kStride_m = 1.4;  ///< Two steps.

/// Nearer to a wall nobody walks, whatever lies behind it.
constexpr double kShoulder_m = 0.15;

/// Is there room at `to`, or at least more than at `from`?
bool is_roomier(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double room_m, const Place& place) {
  return place.has_room(to, room_m) || place.clearance_m(to) > place.clearance_m(from);
}

/// May a person who looks ahead to `ahead` take the step to `next`? Whoever stands too close already may move away.
bool may_step(const Eigen::Vector2d& here, const Eigen::Vector2d& next, const Eigen::Vector2d& ahead,
              const Place& place, std::span<const Disc> others) {
  if (!is_roomier(here, next, kShoulder_m, place) || !is_roomier(here, ahead, kPersonRoom_m, place)) return false;
  return std::none_of(others.begin(), others.end(), [&](const Disc& other) {
    const double reach = other.radius_m + kPersonRoom_m;
    const double after = (ahead - other.centre_in_map).norm();
    return after < reach && after <= (here - other.centre_in_map).norm();
  });
}

}  // namespace

bool Walker::walk(const Eigen::Vector2d& target_in_map, double speed_mps, double dt_s, const Place& place,
                  std::span<const Disc> others) {
  const Eigen::Vector2d here = map_from_person_.position();
  const Eigen::Vector2d to_target = target_in_map - here;
  const double distance = to_target.norm();
  speed_mps_ = 0.0;
  if (distance <= kArrived_m) return true;
  const double wanted = std::atan2(to_target.y(), to_target.x());
  const double look = std::min(kLookAhead_m, distance);
  for (const double aside_deg : {0.0, 30.0, -30.0, 60.0, -60.0, 90.0, -90.0}) {
    const double heading = wanted + from_degrees(aside_deg);
    const Eigen::Vector2d direction{std::cos(heading), std::sin(heading)};
    const double step = std::min(speed_mps * dt_s, distance);
    const Eigen::Vector2d next = here + step * direction;
    if (!may_step(here, next, here + look * direction, place, others)) continue;
    map_from_person_ = {next.x(), next.y(), wrap_to_pi(heading)};
    walked_m_ += step;
    speed_mps_ = speed_mps;
    return distance - step <= kArrived_m;
  }
  return false;
}

void Walker::stand(double turn_rate_radps, double dt_s) {
  speed_mps_ = 0.0;
  map_from_person_.heading = wrap_to_pi(map_from_person_.heading + turn_rate_radps * dt_s);
}

std::array<Disc, 2> Walker::legs() const {
  constexpr double kLegRadius_m = 0.06;
  constexpr double kHalfApart_m = 0.15;
  const double swing = speed_mps_ > 0.0 ? std::sin(2.0 * std::numbers::pi * walked_m_ / kStride_m) : 0.0;
  const Eigen::Vector2d left_in_person{kHalfApart_m * std::sin(swing), kHalfApart_m * std::cos(swing)};
  return {Disc{map_from_person_ * left_in_person, kLegRadius_m},
          Disc{map_from_person_ * Eigen::Vector2d{-left_in_person}, kLegRadius_m}};
}

void Route::find_way(const Eigen::Vector2d& here, const Place& place) {
  if (next_ < direct_until_ || place.has_way(here, corners_[next_], kPersonRoom_m / 2.0)) return;
  const auto way = shortest_walk(place, here, corners_[next_], kPersonRoom_m);
  if (way.empty()) {
    go_on();  // nobody can get there
  } else {
    corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(next_), way.begin() + 1, way.end() - 1);
    direct_until_ = next_ + way.size() - 1;
  }
}

void Route::go_on() {
  ++next_;
  nearest_m_ = std::numeric_limits<double>::infinity();
  without_progress_s_ = 0.0;
}

void Route::follow(Walker& walker, double speed_mps, double dt_s, const Place& place, std::span<const Disc> others) {
  constexpr double kPatience_s = 4.0;
  constexpr double kProgress_m = 0.05;
  if (!finished()) find_way(walker.map_from_person().position(), place);
  if (finished()) return walker.stand(0.0, dt_s);
  const bool arrived = walker.walk(corners_[next_], speed_mps, dt_s, place, others);
  const double distance_m = (corners_[next_] - walker.map_from_person().position()).norm();
  without_progress_s_ += dt_s;
  if (distance_m < nearest_m_ - kProgress_m) {
    nearest_m_ = distance_m;
    without_progress_s_ = 0.0;
  }
  if (arrived || without_progress_s_ > kPatience_s) go_on();
}

PasserBy::PasserBy(const std::vector<Eigen::Vector2d>& ground, Rng rng)
    : rng_(rng), walker_(Pose2{}), speed_mps_(rng_.uniform(0.6, 1.1)) {
  const Eigen::Vector2d start = ground[rng_.index(ground.size())];
  walker_ = Walker{{start.x(), start.y(), rng_.uniform(-std::numbers::pi, std::numbers::pi)}};
}

void PasserBy::step(double dt_s, const Place& place, const std::vector<Eigen::Vector2d>& ground,
                    std::span<const Disc> others) {
  if (rest_s_ > 0.0) {
    rest_s_ -= dt_s;
    return walker_.stand(0.0, dt_s);
  }
  if (route_.finished()) {
    const Eigen::Vector2d goal = ground[rng_.index(ground.size())];
    route_ = Route{shortest_walk(place, walker_.map_from_person().position(), goal, kPersonRoom_m)};
    rest_s_ = rng_.uniform(0.0, 3.0);
    return walker_.stand(0.0, dt_s);
  }
  route_.follow(walker_, speed_mps_, dt_s, place, others);
}

}  // namespace tandem::simulator
