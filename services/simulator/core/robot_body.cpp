#include "services/simulator/core/robot_body.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::simulator {

Contact contact_at(const Hull& hull, const Pose2& map_from_base, const Place& place, std::span<const Disc> people) {
  Contact contact;
  const auto touch = [&](double x_in_base) { (x_in_base >= 0.0 ? contact.front : contact.rear) = true; };
  const double half_length = hull.length_m / 2.0;
  const double half_width = hull.width_m / 2.0;
  for (const auto& person : people) {
    const Eigen::Vector2d in_base = inverse(map_from_base) * person.centre_in_map;
    const Eigen::Vector2d nearest{std::clamp(in_base.x(), -half_length, half_length),
                                  std::clamp(in_base.y(), -half_width, half_width)};
    if ((in_base - nearest).norm() < person.radius_m) touch(in_base.x());
  }
  // No wall within the hull's corners: no need to look at them one by one.
  const double reach = std::hypot(half_length, half_width) + place.map().resolution_m();
  if (place.has_room(map_from_base.position(), reach)) return contact;
  const int along = static_cast<int>(std::ceil(hull.length_m / place.map().resolution_m()));
  const int across = static_cast<int>(std::ceil(hull.width_m / place.map().resolution_m()));
  for (int i = 0; i <= along; ++i) {
    for (int j = 0; j <= across; ++j) {
      const Eigen::Vector2d in_base{hull.length_m * (static_cast<double>(i) / along - 0.5),
                                    hull.width_m * (static_cast<double>(j) / across - 0.5)};
      if (place.map().at(map_from_base * in_base) == CellState::Occupied) touch(in_base.x());
    }
  }
  return contact;
}

Moved RobotBody::move(const Pose2& wheel_motion, const Place& place, std::span<const Disc> people) {
  const Contact before = contact_at(hull_, map_from_base_, place, people);
  if (wheel_motion == Pose2{}) return {before, false};
  const Pose2 next = map_from_base_ * slipped(wheel_motion, slip_, rng_);
  const Contact contact = contact_at(hull_, next, place, people);
  // Whoever touches already may still drive away: forwards out of a rear contact, backwards out of a front one.
  const bool leaves =
      before.any() && ((wheel_motion.x > 0.0 && !before.front) || (wheel_motion.x < 0.0 && !before.rear));
  const bool blocked = contact.any() && !leaves;
  if (!blocked) map_from_base_ = next;
  if (blocked && !touching_) ++collisions_;
  touching_ = contact.any();
  return {contact, blocked};
}

}  // namespace tandem::simulator
