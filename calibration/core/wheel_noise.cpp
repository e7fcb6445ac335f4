#include "calibration/core/wheel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "calibration/core/median.hpp"

namespace tandem {
namespace {

constexpr double kMedianShare = 0.6745;  ///< of a normal deviation
constexpr double kStraightRad = 0.15;    ///< A pair that turned less tells of the way, ...
constexpr double kOnTheSpotM = 0.15;     ///< ... and one that moved less of the turn.
constexpr double kSafety = 2.0;
constexpr double kLeast = 0.02;

double noise_of(const std::vector<double>& shares, double uncalibrated) {
  return shares.empty() ? uncalibrated : std::max(kLeast, kSafety * median(shares) / kMedianShare);
}

}  // namespace

MotionNoise wheel_noise(std::span<const PairResidual> residuals) {
  std::vector<double> ahead;
  std::vector<double> aside;
  std::vector<double> turn_on_way;
  std::vector<double> turn;
  for (const PairResidual& one : residuals) {
    if (std::abs(one.turn_rad) < kStraightRad && one.way_m > kOnTheSpotM) {
      ahead.push_back(std::abs(one.after.x()) / one.way_m);
      aside.push_back(std::abs(one.after.y()) / one.way_m);
      turn_on_way.push_back(std::abs(one.after.z()) / one.way_m);
    } else if (one.way_m < kOnTheSpotM && std::abs(one.turn_rad) > kStraightRad) {
      turn.push_back(std::abs(one.after.z() / one.turn_rad));
    }
  }
  MotionNoise noise = kUncalibratedWheels;
  noise.forward_per_m = noise_of(ahead, noise.forward_per_m);
  noise.sideways_per_m = noise_of(aside, noise.sideways_per_m);
  noise.turn_per_m = noise_of(turn_on_way, noise.turn_per_m);
  noise.turn_per_rad = noise_of(turn, noise.turn_per_rad);
  return noise;
}

}  // namespace tandem
