#include "robot/laser/core/lms_session.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "robot/laser/core/lms_reading.hpp"

namespace tandem {
namespace {

constexpr int kUsualRate = 38'400;
constexpr Duration kAnswerTimeout = from_seconds(0.6);
constexpr Duration kSlowAnswerTimeout = from_seconds(7.0);  // it stops its motor, or writes its flash
constexpr Duration kSettle = from_seconds(0.03);            // the laser changes its rate a moment after the answer
constexpr int kTries = 3;
constexpr double kMissedScans = 3.0;

constexpr std::uint8_t kGood = 0x00;
constexpr std::uint8_t kWrongPassword = 0x01;
constexpr std::uint8_t kTaken = 0x01;  // of variant and configuration

lms::Variant variant_of(const LaserConfig& config) {
  return {.field_deg = static_cast<int>(config.field_of_view_deg),
          .step_centideg = static_cast<int>(std::lround(config.resolution_deg * 100.0))};
}

/// The text in an answer, without what is not printable.
std::string text_in(const lms::Payload& payload) {
  std::string text;
  for (std::size_t i = 1; i + 1 < payload.size(); ++i) {
    if (payload[i] >= 0x20 && payload[i] < 0x7F) text.push_back(static_cast<char>(payload[i]));
  }
  return text;
}

}  // namespace

LmsSession::LmsSession(const LaserConfig& config, Time opened, int baud_rate)
    : config_(config),
      baud_rate_(baud_rate),
      wanted_rate_(config.baud_rate == 0 ? kUsualRate : static_cast<int>(config.baud_rate)),
      variant_(variant_of(config)),
      asked_at_(opened) {
  if (!lms::exists(variant_)) {
    fail("laser.toml: an LMS 2xx has resolution_deg 1 or 0.5, and 0.25 with field_of_view_deg 100 only");
  } else if (baud_rate_ != 0 && !lms::mode_of_rate(wanted_rate_)) {
    fail("laser.toml: baud_rate of an LMS 2xx is 9600, 19200, 38400 or 500000");
  }
}

LaserSession::Output LmsSession::step(std::span<const std::uint8_t> received, Time now) {
  Output output;
  if (state_ == State::Failed) return output;
  if (!has_begun_) {
    has_begun_ = true;
    enter(Phase::Quiet, output, now);
  }
  for (const lms::Event& event : reader_.take(received)) {
    if (event.kind != lms::Event::Kind::Telegram) continue;  // the telegram after it says all
    was_answered_ = true;
    take(event.payload, output, now);
    if (state_ == State::Failed) return output;
  }
  watch_the_time(output, now);
  return output;
}

std::string LmsSession::farewell() const {
  return lms::bytes_of(lms::kToLaser, lms::mode_request(lms::mode::kOnRequest));
}

void LmsSession::enter(Phase phase, Output& output, Time now) {
  phase_ = phase;
  tries_ = 0;
  asked_at_ = now;
  if (phase == Phase::Stream) {
    state_ = State::Streaming;
    reason_.clear();
    last_scan_ = now;
  } else if (phase != Phase::Settle) {
    ask(output, now);
  }
}

void LmsSession::ask(Output& output, Time now) {
  output.send += lms::bytes_of(lms::kToLaser, request());
  asked_at_ = now;
  ++tries_;
  constexpr std::array kNames{"the order to be quiet",
                              "its type",
                              "its status",
                              "its configuration",
                              "the password",
                              "its new configuration",
                              "its field of view",
                              "the line's rate",
                              "",
                              "its status at the new rate",
                              "the order to send scans"};
  reason_ = std::string{"waits for the answer to "} + kNames[static_cast<std::size_t>(phase_)];
}

lms::Payload LmsSession::request() const {
  switch (phase_) {
    case Phase::Quiet:
      return lms::mode_request(lms::mode::kOnRequest);
    case Phase::Type:
      return {lms::command::kType};
    case Phase::ReadConfig:
      return {lms::command::kReadConfig};
    case Phase::Installation:
      return lms::mode_request(lms::mode::kInstallation);
    case Phase::WriteConfig: {
      lms::Payload payload{lms::command::kWriteConfig};
      const lms::ConfigBlock wanted = lms::with_format(block_, wanted_format());
      payload.insert(payload.end(), wanted.begin(), wanted.end());
      return payload;
    }
    case Phase::Variant:
      return lms::variant_request(variant_);
    case Phase::Rate:
      return lms::mode_request(*lms::mode_of_rate(wanted_rate_));
    case Phase::Start:
      return lms::mode_request(lms::mode::kStream);
    case Phase::Status:
    case Phase::Settle:
    case Phase::Verify:
    case Phase::Stream:
      break;
  }
  return {lms::command::kStatus};
}

void LmsSession::take(const lms::Payload& payload, Output& output, Time now) {
  const std::uint8_t answer = payload[0];
  if (answer == lms::command::kPowerOn) return fail("was switched on just now");
  if (phase_ == Phase::Stream) return take_scan(payload, output, now);
  if (answer != (request()[0] | lms::command::kAnswer)) return;  // a former stream, or the answer to a request repeated
  switch (phase_) {
    case Phase::Quiet:
    case Phase::Installation:
    case Phase::Rate:
    case Phase::Start:
      return take_mode_answer(payload, output, now);
    case Phase::Type:
      identity_ = text_in(payload);
      return enter(Phase::Status, output, now);
    case Phase::Status:
      return enter(Phase::ReadConfig, output, now);
    case Phase::ReadConfig:
      return take_config(payload, output, now);
    case Phase::WriteConfig:
      if (payload.size() < 2 || payload[1] != kTaken) return fail("refuses its new configuration");
      format_ = wanted_format();
      return enter(Phase::Variant, output, now);
    case Phase::Variant:
      if (payload.size() < 2 || payload[1] != kTaken) {
        return fail("laser.toml: this laser refuses field_of_view_deg and resolution_deg");
      }
      return enter(must_switch_rate() ? Phase::Rate : Phase::Start, output, now);
    case Phase::Verify:
      return enter(Phase::Start, output, now);
    case Phase::Settle:
    case Phase::Stream:
      return;
  }
}

void LmsSession::take_mode_answer(const lms::Payload& payload, Output& output, Time now) {
  const std::uint8_t result = payload.size() > 1 ? payload[1] : kGood;
  if (result == kWrongPassword) return fail("refuses the password: its configuration cannot be changed");
  if (result != kGood)
    return fail("reports a fault at " + reason_.substr(std::string{"waits for the answer to "}.size()));
  switch (phase_) {
    case Phase::Quiet:
      return enter(Phase::Type, output, now);
    case Phase::Installation:
      return enter(Phase::WriteConfig, output, now);
    case Phase::Rate:
      baud_rate_ = wanted_rate_;
      output.baud_rate = wanted_rate_;
      return enter(Phase::Settle, output, now);
    default:
      return enter(Phase::Stream, output, now);
  }
}

void LmsSession::take_config(const lms::Payload& payload, Output& output, Time now) {
  if (payload.size() < 1 + lms::kLeastConfigBlock + 1) return fail("its configuration makes no sense");
  block_.assign(payload.begin() + 1, payload.end() - 1);
  format_ = lms::format_of(block_);
  enter(format_ == wanted_format() ? Phase::Variant : Phase::Installation, output, now);
}

void LmsSession::take_scan(const lms::Payload& payload, Output& output, Time now) {
  if (payload[0] != (lms::command::kScan | lms::command::kAnswer)) return;
  const auto scan = lms::parse_scan(payload);
  if (!scan || scan->values.size() != lms::value_count(variant_)) {
    ++bad_scans_;
    return;
  }
  last_scan_ = now;
  warning_ = lms::complaint_of(scan->status);
  output.scans.push_back(device_scan_of(*scan, variant_, format_, baud_rate_, config_.range_max_m));
}

void LmsSession::watch_the_time(Output& output, Time now) {
  if (phase_ == Phase::Stream) {
    const double sending_s = baud_rate_ > 0 ? 20.0 * static_cast<double>(lms::value_count(variant_)) / baud_rate_ : 0.0;
    const double limit_s = std::max(config_.scan_timeout_s, kMissedScans * sending_s);
    if (now - last_scan_ <= from_seconds(limit_s)) return;
    const auto silent_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now - last_scan_).count();
    return fail("no scan for " + std::to_string(silent_ms) + " ms");
  }
  if (phase_ == Phase::Settle) {
    if (now - asked_at_ >= kSettle) enter(Phase::Verify, output, now);
    return;
  }
  const bool slow = phase_ == Phase::Installation || phase_ == Phase::WriteConfig || phase_ == Phase::Variant;
  if (now - asked_at_ < (slow ? kSlowAnswerTimeout : kAnswerTimeout)) return;
  if (tries_ >= kTries) {
    const std::string at = baud_rate_ > 0 ? " at " + std::to_string(baud_rate_) + " baud" : "";
    return fail("does not answer" + at + " (" + reason_ + ")");
  }
  ask(output, now);
}

lms::RangeFormat LmsSession::wanted_format() const {
  const std::string& wanted = config_.range_format;
  const bool strength = config_.intensities;
  if (wanted == "8m") return {.measuring_mode = static_cast<std::uint8_t>(strength ? 1 : 0), .millimetres = true};
  if (wanted == "32m") return {.measuring_mode = static_cast<std::uint8_t>(strength ? 5 : 6), .millimetres = true};
  if (wanted == "80m") return {.measuring_mode = static_cast<std::uint8_t>(strength ? 1 : 0), .millimetres = false};
  return format_;
}

bool LmsSession::must_switch_rate() const {
  return baud_rate_ != 0 && baud_rate_ != wanted_rate_;
}

}  // namespace tandem
