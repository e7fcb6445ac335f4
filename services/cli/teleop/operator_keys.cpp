#include "services/cli/teleop/operator_keys.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace tandem::cli {
namespace {

/// What a key asks for, as shares of the operator's speeds.
struct DriveKey {
  char key;
  double forward;
  double turn;
};
// Half the turn rate in a curve: whoever goes ahead turns wide.
constexpr std::array<DriveKey, 6> kDriveKeys{
    {{'w', 1.0, 0.0}, {'s', -1.0, 0.0}, {'a', 0.0, 1.0}, {'d', 0.0, -1.0}, {'q', 1.0, 0.5}, {'e', 1.0, -0.5}}};
/// The letters that end an arrow key's sequence, and the key that means the same.
constexpr std::array<std::pair<char, char>, 4> kArrows{{{'A', 'w'}, {'B', 's'}, {'D', 'a'}, {'C', 'd'}}};
constexpr char kEscape = '\x1b';
constexpr double kSpeedStep_mps = 0.05;
constexpr double kSlowest_mps = 0.05;
constexpr double kFastest_mps = 0.7;

}  // namespace

void OperatorKeys::take(std::string_view bytes, Time now) {
  for (const char byte : bytes) take_byte(byte, now);
}

void OperatorKeys::take_byte(char byte, Time now) {
  const Escape escape = std::exchange(escape_, Escape::None);
  if (byte == kEscape) {
    escape_ = Escape::Begun;
  } else if (escape == Escape::Begun && (byte == '[' || byte == 'O')) {
    escape_ = Escape::Bracket;
  } else if (escape == Escape::Bracket) {
    const auto* arrow = std::ranges::find(kArrows, byte, &std::pair<char, char>::first);
    press(arrow != kArrows.end() ? arrow->second : byte, now);
  } else {
    press(static_cast<char>(std::tolower(static_cast<unsigned char>(byte))), now);
  }
}

void OperatorKeys::press(char key, Time now) {
  const bool repeated = key == held_ && now - pressed_ <= kFirstHold;
  if (!repeated) {
    since_ = now;
    resumed_ = false;
  }
  held_ = key;
  pressed_ = now;
  until_ = now + (repeated ? kRepeatHold : kFirstHold);
  if (key == 'x') quit_ = true;
  if (key == '+' || key == '=') speeds_.forward_mps = std::min(kFastest_mps, speeds_.forward_mps + kSpeedStep_mps);
  if (key == '-') speeds_.forward_mps = std::max(kSlowest_mps, speeds_.forward_mps - kSpeedStep_mps);
  if (key == 'r' && !resumed_ && now - since_ >= kResumeHold) {
    resume_ = to_seconds(now - since_);
    resumed_ = true;
  }
}

Twist2 OperatorKeys::wanted(Time now) const {
  const auto* key = std::ranges::find(kDriveKeys, held_, &DriveKey::key);
  if (key == kDriveKeys.end() || now >= until_) return {};
  return {key->forward * speeds_.forward_mps, 0.0, key->turn * speeds_.turn_rate_radps};
}

std::optional<double> OperatorKeys::take_resume() {
  return std::exchange(resume_, std::nullopt);
}

}  // namespace tandem::cli
