#include "robot/pioneer/base_diagnosis.hpp"

namespace tandem {
namespace {

constexpr Duration kWindow = std::chrono::seconds{10};
constexpr std::uint64_t kTooManyInWindow = 10;  ///< of about a hundred packets
constexpr Duration kEngaging = std::chrono::seconds{2};

}  // namespace

std::string BaseDiagnosis::step(const Signs& signs, Time now) {
  const bool bad_line = line_is_bad(signs.bad_checksums, now);
  if (motors_refuse(signs, now)) return "the motors do not engage: is the STOP button in, or the battery too low?";
  if (signs.decision.battery_return) return "the battery is nearly empty: bring the robot back now";
  if (signs.decision.battery_warning) return "the battery is low: finish soon and charge";
  if (bad_line) return "every tenth packet of the base is damaged: check its cable and adapter";
  const double told = signs.base.deceleration_mps2;
  if (told > 0.0 && told < signs.asked_deceleration_mps2 - 1e-6) {
    return "the base does not take the deceleration it was told: it is slow, and its firmware is to be looked at";
  }
  if (signs.base.watchdog_s > 1.0) {
    return "the base's watchdog takes more than a second: set it to 500 ms (docs/safety.md), until then it is slow";
  }
  return {};
}

bool BaseDiagnosis::line_is_bad(std::uint64_t bad_checksums, Time now) {
  if (now - window_began_ >= kWindow) {
    line_is_bad_ = bad_checksums - bad_at_begin_ >= kTooManyInWindow;
    window_began_ = now;
    bad_at_begin_ = bad_checksums;
  }
  return line_is_bad_;
}

bool BaseDiagnosis::motors_refuse(const Signs& signs, Time now) {
  const bool refused = signs.decision.motion != safety::Motion{} && !signs.base.motors_enabled;
  if (!refused) refused_since_.reset();
  if (refused && !refused_since_) refused_since_ = now;
  return refused && now - *refused_since_ > kEngaging;
}

}  // namespace tandem
