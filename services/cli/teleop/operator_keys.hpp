#pragma once

#include <optional>
#include <string_view>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::cli {

/// How fast an operator drives. The safety gate has the last word.
struct TeleopSpeeds {
  double forward_mps = 0.3;
  double turn_rate_radps = 0.5;
};

/// What the keys of a terminal ask for: hold one to drive, let go to stop.
///
/// A terminal tells no release; it repeats a held key, the first time after up to 0.66 s. So a press counts for
/// kFirstHold, and each repetition for kRepeatHold: whoever lets go stands after that, and after the former if the key
/// was just touched. Any key but those that drive stops at once.
class OperatorKeys {
 public:
  static constexpr Duration kFirstHold = std::chrono::milliseconds{700};
  static constexpr Duration kRepeatHold = std::chrono::milliseconds{250};
  static constexpr Duration kResumeHold = std::chrono::seconds{1};  ///< as the safety gate asks

  explicit OperatorKeys(const TeleopSpeeds& speeds) : speeds_(speeds) {}

  /// Takes what the terminal sent, in any pieces.
  void take(std::string_view bytes, Time now);
  /// The velocity asked for now.
  [[nodiscard]] Twist2 wanted(Time now) const;
  [[nodiscard]] const TeleopSpeeds& speeds() const { return speeds_; }
  [[nodiscard]] bool wants_to_quit() const { return quit_; }
  /// For how long the resume key has been held [s], once it is long enough, and once for each time it is.
  [[nodiscard]] std::optional<double> take_resume();

 private:
  void press(char key, Time now);
  void take_byte(char byte, Time now);

  enum class Escape { None, Begun, Bracket };
  TeleopSpeeds speeds_;
  Escape escape_ = Escape::None;  ///< how much of an arrow key's sequence has come
  char held_ = 0;
  Time since_{};  ///< held without a gap
  Time pressed_{};
  Time until_{};
  bool resumed_ = false;  ///< by the key that is held
  std::optional<double> resume_;
  bool quit_ = false;
};

}  // namespace tandem::cli
