#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "services/common/wheel_correction.hpp"

namespace tandem {

/// What the wheels report between two times, step by step.
struct WheelMotion {
  std::vector<Arc<double>> steps;
  Arc<double> rate_at_start;  ///< [m/s, m/s, rad/s]
  Arc<double> rate_at_end;
};

/// `a_from_b * b_from_c` of motions that may carry derivatives; x, y and heading as in chord_of.
template <typename Scalar>
[[nodiscard]] Arc<Scalar> composed(const Arc<Scalar>& a_from_b, const Arc<Scalar>& b_from_c) {
  using std::cos;
  using std::sin;
  const Scalar c = cos(a_from_b.turn_rad);
  const Scalar s = sin(a_from_b.turn_rad);
  return {a_from_b.forward_m + c * b_from_c.forward_m - s * b_from_c.left_m,
          a_from_b.left_m + s * b_from_c.forward_m + c * b_from_c.left_m, a_from_b.turn_rad + b_from_c.turn_rad};
}

/// b_from_a of a_from_b.
template <typename Scalar>
[[nodiscard]] Arc<Scalar> inverted(const Arc<Scalar>& a_from_b) {
  using std::cos;
  using std::sin;
  const Scalar c = cos(a_from_b.turn_rad);
  const Scalar s = sin(a_from_b.turn_rad);
  return {-c * a_from_b.forward_m - s * a_from_b.left_m, s * a_from_b.forward_m - c * a_from_b.left_m,
          -a_from_b.turn_rad};
}

/// One pair of scans against the wheels (Censi et al., TRO 2013, with the laser's clock as one more unknown):
///
///   r(w, e, d) = W log( M^-1 e^-1 exp(-d v_i(w)) P(w) exp(d v_j(w)) e )
/// with the wheels' corrections w = (left, right, track), the place e of the recorded base in the true base, the time d
/// [s] to add to that which the steps were taken for; P the corrected steps in a row, v their rates at both ends, M the
/// motion that the scans say, and W a root of its information. log is taken as x, y and heading: r is small.
class MotionResidual {
 public:
  MotionResidual(WheelMotion wheels, const Pose2& motion, double half_track_m, const Eigen::Matrix3d& root_information)
      : wheels_(std::move(wheels)),
        end_from_start_(inverse(motion)),
        half_track_m_(half_track_m),
        root_information_(root_information) {}

  template <typename Scalar>
  bool operator()(const Scalar* wheels, const Scalar* laser, const Scalar* delay_s, Scalar* residuals) const {
    const auto driven = [&](const Arc<double>& reported) {
      return corrected<Scalar>(reported, half_track_m_, wheels[0], wheels[1], wheels[2]);
    };
    const auto for_a_time = [](const Arc<Scalar>& rate, const Scalar& seconds) {
      return chord_of(Arc<Scalar>{seconds * rate.forward_m, seconds * rate.left_m, seconds * rate.turn_rad});
    };
    Arc<Scalar> motion = for_a_time(driven(wheels_.rate_at_start), Scalar(-delay_s[0]));
    for (const Arc<double>& step : wheels_.steps) motion = composed(motion, chord_of(driven(step)));
    motion = composed(motion, for_a_time(driven(wheels_.rate_at_end), delay_s[0]));
    const Arc<Scalar> base_from_recorded{laser[0], laser[1], laser[2]};
    motion = composed(composed(inverted(base_from_recorded), motion), base_from_recorded);
    const Arc<Scalar> measured{Scalar(end_from_start_.x), Scalar(end_from_start_.y), Scalar(end_from_start_.heading)};
    const Arc<Scalar> off = composed(measured, motion);
    Eigen::Map<Eigen::Matrix<Scalar, 3, 1>> result{residuals};
    const Scalar turn = off.turn_rad - 2.0 * std::numbers::pi * std::round(turns_of(off.turn_rad));
    result = root_information_.cast<Scalar>() * Eigen::Matrix<Scalar, 3, 1>{off.forward_m, off.left_m, turn};
    return true;
  }

 private:
  static double turns_of(double angle_rad) { return angle_rad / (2.0 * std::numbers::pi); }
  template <typename Jet>
  static double turns_of(const Jet& angle_rad) {
    return turns_of(angle_rad.a);
  }

  WheelMotion wheels_;
  Pose2 end_from_start_;
  double half_track_m_;
  Eigen::Matrix3d root_information_;
};

}  // namespace tandem
