#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/simulator/core/place.hpp"
#include "services/simulator/core/robot_body.hpp"

namespace tandem::simulator {

/// A person's body: walks towards points, goes round what stands in the way, shows two legs to a laser.
class Walker {
 public:
  explicit Walker(const Pose2& map_from_person) : map_from_person_(map_from_person) {}

  /// Walks for `dt_s` towards `target_in_map` at `speed_mps`, aside of walls and `others`; stands if there is no way.
  /// True once the target is reached (0.15 m).
  bool walk(const Eigen::Vector2d& target_in_map, double speed_mps, double dt_s, const Place& place,
            std::span<const Disc> others);
  /// Stands still for a step, turning at `turn_rate_radps`.
  void stand(double turn_rate_radps, double dt_s);

  [[nodiscard]] const Pose2& map_from_person() const { return map_from_person_; }
  [[nodiscard]] double speed_mps() const { return speed_mps_; }
  /// Two discs of 0.06 m, 0.3 m apart, that swing while the person walks.
  [[nodiscard]] std::array<Disc, 2> legs() const;
  /// The ground the person takes.
  [[nodiscard]] Disc body() const { return {map_from_person_.position(), 0.2}; }

 private:
  Pose2 map_from_person_;
  double walked_m_ = 0.0;
  double speed_mps_ = 0.0;
};

/// Follows corners one after the other; where a corner is not straight ahead it finds the way there, once. A corner
/// that comes no nearer for 4 s is left out.
class Route {
 public:
  Route() = default;
  explicit Route(std::vector<Eigen::Vector2d> corners_in_map) : corners_(std::move(corners_in_map)) {}

  [[nodiscard]] bool finished() const { return next_ >= corners_.size(); }
  /// Moves `walker` along the route.
  void follow(Walker& walker, double speed_mps, double dt_s, const Place& place, std::span<const Disc> others);

 private:
  void find_way(const Eigen::Vector2d& here, const Place& place);
  void go_on();

  std::vector<Eigen::Vector2d> corners_;
  std::size_t next_ = 0;
  std::size_t direct_until_ = 0;  ///< Corners before this one belong to a way that was found.
  double nearest_m_ = std::numeric_limits<double>::infinity();
  double without_progress_s_ = 0.0;
};

/// Someone who is not in the search: walks between random points of the ground.
class PasserBy {
 public:
  /// `ground` are the points it may go to; not empty.
  PasserBy(const std::vector<Eigen::Vector2d>& ground, Rng rng);

  void step(double dt_s, const Place& place, const std::vector<Eigen::Vector2d>& ground, std::span<const Disc> others);
  [[nodiscard]] const Walker& walker() const { return walker_; }

 private:
  Rng rng_;
  Walker walker_;
  Route route_;
  double speed_mps_;
  double rest_s_ = 0.0;
};

}  // namespace tandem::simulator
