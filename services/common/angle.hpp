#pragma once

#include <cmath>
#include <numbers>

namespace tandem {

/// `angle_rad` turned by whole turns into [-pi, pi).
[[nodiscard]] inline double wrap_to_pi(double angle_rad) {
  const double turn = 2.0 * std::numbers::pi;
  const double wrapped = angle_rad - turn * std::floor((angle_rad + std::numbers::pi) / turn);
  return wrapped >= std::numbers::pi ? wrapped - turn : wrapped;  // rounding can land on +pi
}

/// The shortest turn from `from_rad` to `to_rad`, in [-pi, pi), counter-clockwise positive.
[[nodiscard]] inline double turn_between(double from_rad, double to_rad) {
  return wrap_to_pi(to_rad - from_rad);
}

[[nodiscard]] constexpr double from_degrees(double angle_deg) {
  return angle_deg * std::numbers::pi / 180.0;
}
[[nodiscard]] constexpr double to_degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

}  // namespace tandem
