#include "bench/localization/simulated_nees.hpp"

#include <Eigen/LU>
#include <cmath>

#include "bench/localization/log_run.hpp"
#include "services/common/random.hpp"
#include "services/localization/core/trajectory_errors.hpp"

namespace tandem::bench {
namespace {

constexpr std::uint64_t kOtherDraws = 1000;  ///< Starts are drawn apart from drives.

}  // namespace

SimulatedErrors simulated_errors(const LocalizationConfig& config, const DriveOptions& options, std::uint64_t drives) {
  SimulatedErrors errors;
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d claimed = Eigen::Matrix3d::Zero();
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    const RecordedLog log = simulated_drive(seed, options);
    Rng rng{seed + kOtherDraws};
    const MotionDeviation start{config.start_deviation_m, config.start_deviation_m, config.start_deviation_m};
    const Pose2 first = sampled_motion(log.truth.front().map_from_base, start, rng);
    RunOptions run{.config = config};
    run.config.start = {first.x, first.y, first.heading};
    for (const RunStep& step : run_log(log, run)) {
      const auto truth = pose_at(log.truth, step.result.time);
      if (!truth) continue;
      const Pose2& pose = step.result.map_from_base;
      const Eigen::Vector3d error{pose.x - truth->x, pose.y - truth->y, turn_between(truth->heading, pose.heading)};
      errors.nees += error.dot(step.result.covariance.inverse() * error) / 3.0;
      const double c = std::cos(truth->heading);
      const double s = std::sin(truth->heading);
      Eigen::Matrix3d to_robot = Eigen::Matrix3d::Identity();
      to_robot.topLeftCorner<2, 2>() << c, s, -s, c;
      square += (to_robot * error) * (to_robot * error).transpose();
      claimed += to_robot * step.result.covariance * to_robot.transpose();
      ++errors.scans;
    }
  }
  if (errors.scans == 0) return errors;
  const auto count = static_cast<double>(errors.scans);
  errors.nees /= count;
  const Eigen::Vector3d actual = (square.diagonal() / count).cwiseSqrt();
  const Eigen::Vector3d said = (claimed.diagonal() / count).cwiseSqrt();
  errors.along_m = actual.x();
  errors.across_m = actual.y();
  errors.turn_rad = actual.z();
  errors.claimed_along_m = said.x();
  errors.claimed_across_m = said.y();
  errors.claimed_turn_rad = said.z();
  return errors;
}

}  // namespace tandem::bench
