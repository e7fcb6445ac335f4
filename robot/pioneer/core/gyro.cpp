#include "robot/pioneer/core/gyro.hpp"

#include <cmath>
#include <utility>

#include "services/common/angle.hpp"

namespace tandem::pioneer {
namespace {

constexpr double kScaler = 1.626;
constexpr double kRadiansPerCount = from_degrees(5.0 / 1023.0 * 300.0 / 2.5 * kScaler) * 0.025;
constexpr int kLargest = 1023;
constexpr int kReadingsAtRest = 40;  ///< a second
constexpr double kSteady = 0.005;    ///< of the mean: a robot that is pushed is not at rest
constexpr double kNoise = 2.0;       ///< at rest less than this is no turn

}  // namespace

void Gyro::take(const std::vector<GyroReading>& readings, bool standing) {
  for (const auto& [rate, temperature] : readings) {
    if (rate == 0 || rate >= kLargest) continue;  // saturated, or not there
    const bool steady = count_ == 0 || std::abs(sum_ / count_ - rate) < kSteady * sum_ / count_;
    if (!standing || !steady) {
      sum_ = 0.0;
      count_ = 0;
    }
    if (standing) {
      sum_ += rate;
      ++count_;
    }
    if (count_ >= kReadingsAtRest) {
      rest_ = sum_ / count_;
      sum_ = 0.0;
      count_ = 0;
    }
    if (!rest_) continue;
    const double beyond = rate - *rest_;
    turn_rad_ = turn_rad_.value_or(0.0) - (standing && std::abs(beyond) < kNoise ? 0.0 : beyond * kRadiansPerCount);
  }
}

std::optional<double> Gyro::take_turn() {
  return std::exchange(turn_rad_, std::nullopt);
}

}  // namespace tandem::pioneer
