#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/simulator/core/place.hpp"
#include "services/simulator/core/wheels.hpp"

namespace tandem::simulator {

/// A round thing that stands in the way, or a leg that a laser meets.
struct Disc {
  Eigen::Vector2d centre_in_map;  ///< [m]
  double radius_m = 0.0;
};

/// The rectangular hull, centred on the base.
struct Hull {
  double length_m = 0.626;
  double width_m = 0.505;
};

/// Where a hull touches something.
struct Contact {
  bool front = false;
  bool rear = false;

  [[nodiscard]] bool any() const { return front || rear; }
};

/// Where the hull at `map_from_base` overlaps walls or `people`.
[[nodiscard]] Contact contact_at(const Hull& hull, const Pose2& map_from_base, const Place& place,
                                 std::span<const Disc> people);

/// What became of a motion.
struct Moved {
  Contact contact;
  bool blocked = false;  ///< The wheels could not turn.
};

/// The robot as a thing in the world: it goes where its wheels push it, unless something is in the way.
class RobotBody {
 public:
  RobotBody(const Hull& hull, const SlipModel& slip, const Pose2& map_from_base, Rng rng)
      : hull_(hull), slip_(slip), map_from_base_(map_from_base), rng_(rng) {}

  /// Moves by what the wheels want to turn, with slip. In contact it stays where it is, and may only move out of it.
  Moved move(const Pose2& wheel_motion, const Place& place, std::span<const Disc> people);

  [[nodiscard]] const Pose2& map_from_base() const { return map_from_base_; }
  /// Times that it ran into something.
  [[nodiscard]] int collisions() const { return collisions_; }

 private:
  Hull hull_;
  SlipModel slip_;
  Pose2 map_from_base_;
  Rng rng_;
  bool touching_ = false;
  int collisions_ = 0;
};

}  // namespace tandem::simulator
