#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/pioneer/core/gyro.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "robot/pioneer/core/sip.hpp"
#include "services/common/config.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/common/wheel_correction.hpp"

namespace tandem::pioneer {

/// Part of base.toml. How odometry errs, as random walks; a skid-steered robot turns by slipping, so its heading is far
/// worse.
struct OdometryNoise {
  double distance_per_root_m = 0.02;  ///< Of the way ahead and aside [m / sqrt(m)].
  double turn_per_root_rad = 0.03;    ///< Of the turn [rad / sqrt(rad)].
  double turn_per_root_m = 0.01;      ///< Of the turn, per root of the way [rad / sqrt(m)].
  double skid_steer_factor = 4.0;     ///< Both of the above, for a robot without castor.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("odometry_distance_per_root_m", distance_per_root_m, Range{1e-4, 1.0});
    visitor.field("odometry_turn_per_root_rad", turn_per_root_rad, Range{1e-4, 1.0});
    visitor.field("odometry_turn_per_root_m", turn_per_root_m, Range{1e-4, 1.0});
    visitor.field("odometry_skid_steer_factor", skid_steer_factor, Range{1.0, 100.0});
  }
};

/// Where the wheels say the robot is.
struct OdometryState {
  Pose2 odom_from_base;
  Twist2 velocity;
  Covariance3 covariance = Covariance3::Zero();  ///< of the pose, since the epoch began
  std::uint32_t epoch = 0;
  bool jumped = false;  ///< the step that came with this packet was impossible and is left out
};

/// Follows the counters of the controller: x and y wrap at 15 bits, the heading at a turn.
class Odometry {
 public:
  Odometry(const OdometryNoise& noise, std::uint32_t first_epoch, const WheelCorrection& wheels = {})
      : noise_(noise), wheels_(wheels) {
    state_.epoch = first_epoch;
  }

  /// A controller that was just opened counts from anywhere: the pose stays, a new epoch begins unless it is the first,
  /// and the next packet only sets the reference.
  void restart(const RobotParameters& parameters);
  /// Takes a packet measured at `stamp`.
  const OdometryState& take(const Sip& sip, Time stamp);
  /// Takes readings of the gyro: from then on it says how far the robot turned, and the wheels how far it went.
  void take(const std::vector<GyroReading>& readings);
  [[nodiscard]] const OdometryState& state() const { return state_; }
  /// Impossible steps left out so far.
  [[nodiscard]] std::uint64_t jumps() const { return jumps_; }

 private:
  struct Reference {
    int x = 0;
    int y = 0;
    int heading = 0;
    Time stamp{};
  };
  enum class TurnFrom { Wheels, Gyro };
  void move(const Pose2& step, TurnFrom turn_from);

  OdometryNoise noise_;
  WheelCorrection wheels_;
  RobotParameters parameters_;
  Gyro gyro_;
  bool opened_before_ = false;
  std::optional<Reference> reference_;
  OdometryState state_;
  std::uint64_t jumps_ = 0;
};

}  // namespace tandem::pioneer
