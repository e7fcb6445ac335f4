#include "robot/laser/core/scip_session.hpp"

#include <algorithm>

#include "robot/laser/core/scip_encoding.hpp"
#include "robot/laser/core/scip_reading.hpp"

namespace tandem {
namespace {

constexpr Duration kAnswerTimeout = from_seconds(0.6);
constexpr Duration kQuiet = from_seconds(0.1);         // no byte for so long: a former stream has ended
constexpr Duration kQuietTimeout = from_seconds(1.5);  // it will not end: go on, answers are known by their echo
constexpr Duration kSettle = from_seconds(0.05);       // the sensor changes its rate a moment after the answer
constexpr int kTries = 4;

constexpr std::string_view kGood = "00";
constexpr std::string_view kUnknown = "0E";   // to QT: the sensor is still in its time-adjust state
constexpr std::string_view kOldSensor = "E";  // to QT: it speaks SCIP 1.1
constexpr std::string_view kLightAlready = "02";
constexpr std::string_view kRateAlready = "03";
constexpr std::string_view kAbnormal = "0L";
constexpr std::string_view kWell = "works well";  // of STAT

/// What a status other than 00 means, in the words of the specification.
std::string meaning(const std::string& status) {
  if (status == "04") return "04, the last step is outside its field of view";
  if (status == "05") return "05, the last step is before the first";
  if (status == "0L") return "0L, it is in an abnormal state";
  if (status == "10") return "10, refused in its present state";
  if (status >= "21" && status <= "49") return status + ", it stopped by a hardware error";
  if (status >= "50" && status <= "97") return status + ", hardware trouble";
  return status;
}

/// The value of "KEY:value" among `lines`, empty if there is none.
std::string value_of(const std::vector<std::string>& lines, std::string_view key) {
  const auto line = std::find_if(lines.begin(), lines.end(), [key](const auto& text) { return text.starts_with(key); });
  return line == lines.end() ? "" : line->substr(key.size());
}

DeviceScan device_scan_of(const scip::ScanData& scan, const scip::SensorParameters& sensor, double range_max_m) {
  const double turn_s = scip::turn_period_s(sensor);
  DeviceScan out;
  out.reading = reading_of(scan, sensor, Time{}, range_max_m);
  out.clock = scan.timestamp_ms;
  out.least_delay = from_seconds(turn_s * scan.request.last_step / sensor.steps_per_turn);  // up to the last step read
  out.mark_to_first_beam = out.reading.first_beam - Time{};
  out.period_s = turn_s * (scan.request.skip + 1);
  return out;
}

}  // namespace

ScipSession::ScipSession(const LaserConfig& config, Time opened, int baud_rate)
    : config_(config), baud_rate_(baud_rate), asked_at_(opened) {}

LaserSession::Output ScipSession::step(std::span<const std::uint8_t> received, Time now) {
  Output output;
  if (state_ == State::Failed) return output;
  if (!has_begun_) {
    has_begun_ = true;
    last_byte_ = now;
    enter(Phase::Quiet, output, now);
  }
  if (!received.empty()) last_byte_ = now;
  for (const scip::Reply& reply : parser_.take(received)) {
    was_answered_ = true;
    take_reply(reply, output, now);
    if (state_ == State::Failed) return output;
  }
  watch_the_time(output, now);
  return output;
}

void ScipSession::ask(const std::string& line, Output& output, Time now) {
  output.send += line + "\n";
  asked_ = line;
  asked_at_ = now;
  ++tries_;
}

void ScipSession::enter(Phase phase, Output& output, Time now) {
  phase_ = phase;
  tries_ = 0;
  if (phase == Phase::Stream) {
    state_ = State::Streaming;
    reason_.clear();
    last_scan_ = now;
    return;
  }
  if (phase == Phase::Settle) {
    asked_at_ = now;
    return;
  }
  ask(request_of(phase), output, now);
  reason_ = "waits for the answer to " + asked_;
}

void ScipSession::advance(Output& output, Time now) {
  switch (phase_) {
    case Phase::Quiet:
      return enter(baud_rate_ != 0 && config_.baud_rate != 0 ? Phase::Version : Phase::Reset, output, now);
    case Phase::Status:
      return enter(must_switch_rate() ? Phase::Rate : Phase::Light, output, now);
    default:
      return enter(static_cast<Phase>(static_cast<int>(phase_) + 1), output, now);
  }
}

bool ScipSession::must_switch_rate() const {
  return baud_rate_ != 0 && config_.baud_rate != 0 && baud_rate_ != config_.baud_rate;
}

std::string ScipSession::request_of(Phase phase) const {
  switch (phase) {
    case Phase::Quiet:
      return "QT";
    case Phase::Reset:
      return "RS";
    case Phase::Version:
      return "VV";
    case Phase::Parameters:
      return "PP";
    case Phase::Status:
      return "II";
    case Phase::Rate:
      return "SS" + scip::decimal(static_cast<int>(config_.baud_rate), 6);
    case Phase::Light:
      return "BM";
    case Phase::Settle:
    case Phase::Start:
    case Phase::Stream:
      break;
  }
  return scip::line_of(stream_);
}

void ScipSession::take_reply(const scip::Reply& reply, Output& output, Time now) {
  if (phase_ == Phase::Stream) return take_streamed(reply, output, now);
  if (phase_ == Phase::Quiet) return take_quiet_reply(reply, output, now);
  if (phase_ == Phase::Start && is_from_our_stream(reply)) return take_start(reply, output, now);
  if (reply.echo != asked_) return;  // of a former stream, or the answer to a request repeated
  switch (phase_) {
    case Phase::Reset:
      return advance(output, now);
    case Phase::Status:
      return take_status(reply, output, now);
    case Phase::Rate:
      return take_rate(reply, output, now);
    case Phase::Version:
      identity_ = value_of(reply.data, "PROD:") + ", firmware " + value_of(reply.data, "FIRM:") + ", serial " +
                  value_of(reply.data, "SERI:");
      return advance(output, now);
    case Phase::Parameters:
      return take_parameters(reply, output, now);
    case Phase::Light:
      return take_light(reply, output, now);
    default:
      return;
  }
}

void ScipSession::take_quiet_reply(const scip::Reply& reply, Output& output, Time now) {
  if (reply.echo != asked_) return;
  if (tries_ >= 2 * kTries) return fail("answers QT with " + meaning(reply.status) + " again and again");
  if (asked_ != "QT") {  // it has left the state it was in: once more
    ask("QT", output, now);
  } else if (reply.status == kUnknown) {
    ask("TM2", output, now);
  } else if (reply.status == kOldSensor) {
    ask("SCIP2.0", output, now);
  } else {
    quit_answered_ = true;
  }
}

void ScipSession::take_parameters(const scip::Reply& reply, Output& output, Time now) {
  sensor_ = scip::parse_parameters(reply.data);
  if (!sensor_) return fail("its answer to PP makes no sense");
  stream_.command = config_.intensities ? "ME" : "MD";
  stream_.first_step = config_.first_step < 0 ? sensor_->first_step : static_cast<int>(config_.first_step);
  stream_.last_step = config_.last_step < 0 ? sensor_->last_step : static_cast<int>(config_.last_step);
  stream_.cluster = static_cast<int>(config_.cluster);
  stream_.skip = static_cast<int>(config_.skip);
  if (stream_.first_step < sensor_->first_step || stream_.last_step > sensor_->last_step ||
      stream_.first_step >= stream_.last_step) {
    return fail("laser.toml: first_step and last_step must lie in [" + std::to_string(sensor_->first_step) + ", " +
                std::to_string(sensor_->last_step) + "], the field of view of this " + sensor_->model);
  }
  advance(output, now);
}

void ScipSession::take_status(const scip::Reply& reply, Output& output, Time now) {
  const std::string state = value_of(reply.data, "STAT:");
  if (!state.empty() && state.find(kWell) == std::string::npos) warning_ = "the sensor says: " + state;
  advance(output, now);
}

void ScipSession::take_rate(const scip::Reply& reply, Output& output, Time now) {
  if (reply.status == kRateAlready) return enter(Phase::Light, output, now);
  if (reply.status != kGood) {
    return fail("laser.toml: this sensor cannot send at baud_rate (answer " + meaning(reply.status) + ")");
  }
  baud_rate_ = static_cast<int>(config_.baud_rate);
  output.baud_rate = baud_rate_;
  advance(output, now);
}

void ScipSession::take_light(const scip::Reply& reply, Output& output, Time now) {
  if (reply.status == kGood || reply.status == kLightAlready) return advance(output, now);
  if (reply.status == kAbnormal) return reboot(output);
  fail("cannot light its laser (answer " + meaning(reply.status) + "): dirty, still starting, or broken");
}

void ScipSession::take_start(const scip::Reply& reply, Output& output, Time now) {
  if (reply.status == kGood) return advance(output, now);
  if (reply.status == "99") return;  // a former stream with our parameters
  if (reply.status == kAbnormal) return reboot(output);
  if (reply.status == kUnknown && config_.intensities) {
    return fail("laser.toml: this " + sensor_->model + " gives no intensities");
  }
  fail("refuses " + asked_ + " (answer " + meaning(reply.status) + ")");
}

void ScipSession::reboot(Output& output) {
  output.send += "RB\nRB\n";  // the second confirms it
  fail("is in an abnormal state (answer 0L): it is rebooted");
}

bool ScipSession::is_from_our_stream(const scip::Reply& reply) const {
  const auto request = scip::parse_request(reply.echo);
  if (!request) return false;
  const auto parsed = scip::parse_scan_request(*request);
  const auto* echoed = std::get_if<scip::ScanRequest>(&parsed);
  if (echoed == nullptr) return false;
  scip::ScanRequest with_our_count = *echoed;
  with_our_count.count = stream_.count;  // in a reply it says how many are left
  return with_our_count == stream_;
}

void ScipSession::take_streamed(const scip::Reply& reply, Output& output, Time now) {
  if (!is_from_our_stream(reply)) return;
  if (reply.status >= "21" && reply.status <= "97") return fail("answers " + meaning(reply.status));
  if (reply.status != "99") return;  // 00: the acknowledgement again; 98: it goes on after a fault
  if (auto scan = scip::parse_scan(reply)) {
    last_scan_ = now;
    output.scans.push_back(device_scan_of(*scan, *sensor_, config_.range_max_m));
  } else {
    ++bad_scans_;
  }
}

void ScipSession::watch_the_time(Output& output, Time now) {
  if (phase_ == Phase::Stream) {
    if (now - last_scan_ > from_seconds(config_.scan_timeout_s)) {
      fail("no scan for " +
           std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(now - last_scan_).count()) + " ms");
    }
    return;
  }
  if (phase_ == Phase::Settle) {
    if (now - asked_at_ >= kSettle) advance(output, now);
    return;
  }
  if (phase_ == Phase::Quiet && quit_answered_) {
    if (now - last_byte_ >= kQuiet || now - asked_at_ >= kQuietTimeout) advance(output, now);
    return;
  }
  if (now - asked_at_ < kAnswerTimeout) return;
  if (tries_ >= kTries) {
    if (phase_ == Phase::Version) was_answered_ = false;  // RS may have put the line to another rate
    return fail("does not answer " + request_of(phase_));
  }
  ask(request_of(phase_), output, now);
}

}  // namespace tandem
