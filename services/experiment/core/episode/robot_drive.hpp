#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "services/common/random.hpp"
#include "services/navigator/core/navigator.hpp"
#include "services/simulator/core/place.hpp"
#include "services/simulator/core/robot_body.hpp"

namespace tandem::experiment {

/// Somebody on the floor.
struct Bystander {
  simulator::Disc body;
  Eigen::Vector2d velocity_in_map_mps = Eigen::Vector2d::Zero();
};

/// What came of driving so far.
struct DriveTally {
  int stops = 0;            ///< Times it stood for half a second or more before something in its way.
  int collisions = 0;       ///< Times it ran into a wall or into somebody.
  int near_collisions = 0;  ///< Times it moved with somebody within 0.15 m of its hull.
  double distance_m = 0.0;
  double longest_idle_s = 0.0;  ///< The longest time that it neither drove nor turned.
};

/// The robot of an episode: its navigator, told where it is, and its body, pushed by ideal wheels that slip a little.
class RobotDrive {
 public:
  /// `config.period_s` is the step of the episode.
  RobotDrive(const navigator::NavigatorConfig& config, const simulator::SlipModel& slip, const Pose2& start, Rng rng);

  void hear(navigator::PlanNews news, Time now) { navigator_.receive_plan(std::move(news), now); }

  /// Drives for one period. `may_move`: it has an accepted plan. `now` is the end of the period.
  void step(Time now, const std::string& session, bool may_move, const simulator::Place& place,
            std::span<const Bystander> people);

  [[nodiscard]] const Pose2& map_from_base() const { return body_.map_from_base(); }
  /// The plan it follows, and how far it is with it.
  [[nodiscard]] const navigator::Execution& execution() const { return execution_; }
  [[nodiscard]] const DriveTally& tally() const { return tally_; }

 private:
  [[nodiscard]] navigator::Situation situation(Time now, const std::string& session, const simulator::Place& place,
                                               std::span<const Bystander> people) const;
  void count(bool may_move, double moved_m, std::span<const Bystander> people);

  double period_s_;
  simulator::Hull hull_;
  navigator::Navigator navigator_;
  simulator::RobotBody body_;
  Twist2 velocity_;
  navigator::Execution execution_;
  DriveTally tally_;
  double held_s_ = 0.0;
  double idle_s_ = 0.0;
  bool near_ = false;
};

}  // namespace tandem::experiment
