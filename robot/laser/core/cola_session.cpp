#include "robot/laser/core/cola_session.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr Duration kAnswerTimeout = from_seconds(1.0);
constexpr Duration kAskStateAgain = from_seconds(0.5);
constexpr Duration kWarmUp = from_seconds(70.0);
constexpr int kTries = 3;

constexpr std::int64_t kMeasuring = 7;  // of STlms
constexpr std::int64_t kReady = 1;      // of SCdevicestate
constexpr std::int64_t kBroken = 2;

/// The name in a request or in the answer to it: the second word.
std::string_view name_in(const cola::Words& words) {
  return words.size() > 1 ? std::string_view{words[1]} : std::string_view{};
}

/// The kind of the answer to a request of `kind`.
std::string_view answer_to(std::string_view kind) {
  if (kind == "sRN") return "sRA";
  if (kind == "sWN") return "sWA";
  if (kind == "sMN") return "sAN";
  return "sEA";
}

std::string joined(const cola::Words& words, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < words.size(); ++i) text += (text.empty() ? "" : " ") + words[i];
  return text;
}

}  // namespace

ColaSession::ColaSession(const LaserConfig& config, Time opened) : config_(config), asked_at_(opened) {}

LaserSession::Output ColaSession::step(std::span<const std::uint8_t> received, Time now) {
  Output output;
  if (state_ == State::Failed) return output;
  if (!has_begun_) {
    has_begun_ = true;
    enter(Phase::Quiet, output, now);
  }
  for (const std::string& text : reader_.take(received)) {
    was_answered_ = true;
    take(text, output, now);
    if (state_ == State::Failed) return output;
  }
  if (reader_.saw_binary() && state_ != State::Streaming) {
    fail("speaks CoLa B, the binary form: switch it to CoLa A (ASCII) with SICK's SOPAS tool");
    return output;
  }
  watch_the_time(output, now);
  return output;
}

std::string ColaSession::request() const {
  switch (phase_) {
    case Phase::Quiet:
      return "sEN LMDscandata 0";
    case Phase::Identity:
      return "sRN DeviceIdent";
    case Phase::Login:
      return "sMN SetAccessMode 03 F4724744";  // authorised client
    case Phase::Content:
      return std::string{"sWN LMDscandatacfg 01 00 "} + (config_.intensities ? "1" : "0") +
             " 1 0 00 00 0 0 0 0 +1";  // strengths of 16 bits; no encoder, name, comment or time; each scan
    case Phase::Measure:
      return "sMN LMCstartmeas";
    case Phase::Run:
      return "sMN Run";
    case Phase::State:
      return "sRN STlms";
    case Phase::TimState:
      return "sRN SCdevicestate";
    case Phase::Start:
    case Phase::Stream:
      break;
  }
  return "sEN LMDscandata 1";
}

void ColaSession::enter(Phase phase, Output& output, Time now) {
  phase_ = phase;
  tries_ = 0;
  is_warming_up_ = false;
  state_since_ = now;
  if (phase == Phase::Stream) {
    state_ = State::Streaming;
    reason_.clear();
    last_scan_ = now;
  } else {
    ask(output, now);
  }
}

void ColaSession::ask(Output& output, Time now) {
  output.send += cola::bytes_of(request());
  asked_at_ = now;
  ++tries_;
  if (!is_warming_up_) reason_ = "waits for the answer to " + request();
}

void ColaSession::take(std::string_view text, Output& output, Time now) {
  const cola::Words words = cola::words_of(text);
  if (phase_ == Phase::Stream) {
    if (name_in(words) == "LMDscandata" && words[0] == "sSN") take_scan(text, output, now);
    return;
  }
  if (words[0] == "sFA") return take_refusal(output, now);
  const cola::Words asked = cola::words_of(request());
  if (words[0] != answer_to(asked[0]) || name_in(words) != asked[1]) return;  // a scan, or an answer that came late
  switch (phase_) {
    case Phase::Identity:
      identity_ = joined(words, 2);
      return enter(Phase::Login, output, now);
    case Phase::Login:
      if (words.size() < 3 || words[2] != "1") return fail("refuses the login: has its password been changed?");
      return enter(Phase::Content, output, now);
    case Phase::Run:
      return enter(Phase::State, output, now);
    case Phase::State:
    case Phase::TimState:
      return take_state(words, output, now);
    default:
      return enter(static_cast<Phase>(static_cast<int>(phase_) + 1), output, now);
  }
}

void ColaSession::take_refusal(Output& output, Time now) {
  switch (phase_) {
    case Phase::Quiet:
    case Phase::Identity:
    case Phase::Measure:  // a TiM measures by itself
      return enter(static_cast<Phase>(static_cast<int>(phase_) + 1), output, now);
    case Phase::State:
      return enter(Phase::TimState, output, now);
    default:
      return fail("refuses " + request());
  }
}

void ColaSession::take_state(const cola::Words& words, Output& output, Time now) {
  const auto state = words.size() > 2 ? cola::parse_number(words[2]) : std::nullopt;
  if (!state) return fail("its answer to " + request() + " makes no sense");
  if (phase_ == Phase::TimState && *state == kBroken) return fail("reports that it is broken (device state 2)");
  if (*state == (phase_ == Phase::State ? kMeasuring : kReady)) return enter(Phase::Start, output, now);
  is_warming_up_ = true;
  tries_ = 0;
  reason_ = "warms up (state " + std::to_string(*state) + ")";
}

void ColaSession::take_scan(std::string_view text, Output& output, Time now) {
  const auto scan = cola::parse_scan(text);
  auto device_scan = scan ? cola::device_scan_of(*scan, config_.range_max_m) : std::nullopt;
  if (!device_scan) {
    ++bad_scans_;
    return;
  }
  last_scan_ = now;
  warning_ = cola::complaint_of(scan->status);
  output.scans.push_back(std::move(*device_scan));
}

void ColaSession::watch_the_time(Output& output, Time now) {
  if (phase_ == Phase::Stream) {
    if (now - last_scan_ <= from_seconds(config_.scan_timeout_s)) return;
    const auto silent_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now - last_scan_).count();
    return fail("no scan for " + std::to_string(silent_ms) + " ms");
  }
  if (is_warming_up_) {
    if (now - state_since_ > kWarmUp) return fail("does not begin to measure: it " + reason_);
    if (tries_ == 0 && now - asked_at_ >= kAskStateAgain) return ask(output, now);
  }
  if (now - asked_at_ < kAnswerTimeout) return;
  if (tries_ >= kTries) return fail("does not answer " + request());
  ask(output, now);
}

}  // namespace tandem
