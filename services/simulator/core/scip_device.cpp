#include "services/simulator/core/scip_device.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::simulator {
namespace {

constexpr std::uint32_t kClockMask = 0xFFFFFF;  ///< 24 bits: wraps after 4 h 40 min.

std::string reply(const std::string& echo, const std::string& status, std::vector<std::string> data = {}) {
  return scip::bytes_of(scip::Reply{.echo = echo, .status = status, .data = std::move(data)});
}

}  // namespace

ScipDevice::ScipDevice(scip::SensorParameters sensor, Time now, std::uint32_t clock_start_ms)
    : sensor_(std::move(sensor)), started_(now), clock_start_ms_(clock_start_ms) {}

std::string ScipDevice::receive(std::span<const std::uint8_t> bytes, Time now) {
  std::string answers;
  for (const auto& line : reader_.take(bytes)) {
    if (line.empty()) continue;
    const auto request = scip::parse_request(line);
    answers += request ? answer(*request, now) : reply(line, "0C");
  }
  return answers;
}

std::string ScipDevice::answer(const scip::Request& request, Time now) {
  const std::string& command = request.command;
  if (command == "VV") return reply(request.line, "00", version_lines());
  if (command == "PP") return reply(request.line, "00", scip::parameter_lines(sensor_));
  if (command == "II") return reply(request.line, "00", state_lines(now));
  if (command == "TM") return answer_to_time_request(request, now);
  if (command == "SCIP2.0" || command == "SS" || command == "CR" || command == "HS") return reply(request.line, "00");
  if (command == "BM") {
    if (adjusting_time_) return reply(request.line, "10");
    const bool was_on = laser_on_;
    laser_on_ = true;
    return reply(request.line, was_on ? "02" : "00");
  }
  if (command == "QT" || command == "RS") {
    stream_.reset();
    single_.reset();
    laser_on_ = false;
    if (command == "RS") {
      adjusting_time_ = false;
      started_ = now;
      clock_start_ms_ = 0;
    }
    return reply(request.line, "00");
  }
  if (scip::is_stream(command) || scip::is_single(command)) return answer_to_scan_request(request);
  return reply(request.line, "0E");
}

std::string ScipDevice::answer_to_scan_request(const scip::Request& request) {
  const auto parsed = scip::parse_scan_request(request, sensor_);
  if (const auto* refusal = std::get_if<std::string>(&parsed)) return reply(request.line, *refusal);
  if (adjusting_time_) return reply(request.line, "10");
  const auto& scan_request = std::get<scip::ScanRequest>(parsed);
  if (scip::is_stream(request.command)) {
    laser_on_ = true;
    stream_ = scan_request;
    scans_left_ = scan_request.count;
    turns_to_skip_ = 0;
    return reply(request.line, "00");
  }
  if (!laser_on_) return reply(request.line, "10");
  single_ = scan_request;
  return {};
}

std::string ScipDevice::answer_to_time_request(const scip::Request& request, Time now) {
  if (request.parameters == "0") {
    if (stream_) return reply(request.line, "10");  // the time is adjusted before streaming only
    const bool was_adjusting = adjusting_time_;
    adjusting_time_ = true;
    return reply(request.line, was_adjusting ? "02" : "00");
  }
  if (request.parameters == "1") {
    if (!adjusting_time_) return reply(request.line, "04");
    return reply(request.line, "00", {scip::timestamp_data(clock_ms(now))});
  }
  if (request.parameters == "2") {
    const bool was_adjusting = adjusting_time_;
    adjusting_time_ = false;
    return reply(request.line, was_adjusting ? "00" : "03");
  }
  return reply(request.line, "01");
}

std::string ScipDevice::end_turn(Time turn_start, const Measure& measure) {
  std::string out;
  if (single_) {
    out += scip::bytes_of(scan(*single_, turn_start, measure));
    single_.reset();
  }
  if (!stream_) return out;
  if (turns_to_skip_ > 0) {
    --turns_to_skip_;
    return out;
  }
  turns_to_skip_ = stream_->skip;
  scip::ScanRequest shown = *stream_;
  const bool counted = stream_->count > 0;
  if (counted) --scans_left_;
  shown.count = scans_left_;
  out += scip::bytes_of(scan(shown, turn_start, measure));
  if (counted && scans_left_ == 0) stream_.reset();
  return out;
}

scip::ScanData ScipDevice::scan(const scip::ScanRequest& request, Time turn_start, const Measure& measure) const {
  const int steps = scip::steps_per_value(request);
  std::vector<ScanBeam> beams(scip::value_count(request));
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const int first = request.first_step + static_cast<int>(i) * steps;
    const int last = std::min(first + steps - 1, request.last_step);
    beams[i].step = 0.5 * (first + last);
  }
  scip::ScanData data{.request = request, .timestamp_ms = clock_ms(turn_start)};
  constexpr std::uint32_t kNoEcho = 1;                                        // below DMIN: an error code
  const std::uint32_t most_mm = request.command[1] == 'S' ? 0xFFF : 0x3FFFF;  // two characters, or three
  for (const double range_m : measure(beams)) {
    const bool seen = std::isfinite(range_m);
    data.ranges_mm.push_back(seen ? std::min(static_cast<std::uint32_t>(std::lround(range_m * 1000.0)), most_mm)
                                  : kNoEcho);
    if (request.command[1] == 'E') data.intensities.push_back(seen ? 1000 : 0);
  }
  return data;
}

std::vector<std::string> ScipDevice::version_lines() const {
  return {"VEND:Tandem simulator", "PROD:" + sensor_.model, "FIRM:1.0.0", "PROT:SCIP 2.0", "SERI:H0000001"};
}

std::vector<std::string> ScipDevice::state_lines(Time now) const {
  return {"MODL:" + sensor_.model,
          std::string{"LASR:"} + (laser_on_ ? "ON" : "OFF"),
          "SCSP:" + std::to_string(sensor_.turns_per_minute) + "[rpm]",
          std::string{"MESM:"} + (is_measuring() ? "Measuring by Sensitive Mode" : "Idle"),
          "SBPS:USB only",
          "TIME:" + scip::timestamp_data(clock_ms(now)),
          "STAT:Sensor works well."};
}

std::uint32_t ScipDevice::clock_ms(Time time) const {
  const auto since = (time - started_) / std::chrono::milliseconds{1};
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(clock_start_ms_ + since) & kClockMask);
}

}  // namespace tandem::simulator
