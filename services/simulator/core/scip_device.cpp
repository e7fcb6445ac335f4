#include "services/simulator/core/scip_device.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tandem::simulator {
namespace {

constexpr std::uint32_t kClockMask = 0xFFFFFF;  ///< 24 bits: wraps after 4 h 40 min.

std::string reply(const std::string& echo, const std::string& status, std::vector<std::string> data = {}) {
  return scip::bytes_of(scip::Reply{.echo = echo, .status = status, .data = std::move(data)});
}

}  // namespace

ScipOptions urg_04lx_serial() {
  return {.parameters = scip::urg_04lx(), .has_intensities = false, .wakes_in_version_1 = true, .baud_rate = 19'200};
}

ScipDevice::ScipDevice(ScipOptions options, Time now)
    : options_(std::move(options)),
      sensor_(options_.parameters),
      started_(now),
      clock_start_ms_(options_.clock_start_ms),
      in_version_1_(options_.wakes_in_version_1),
      baud_rate_(options_.baud_rate),
      line_free_(now) {}

std::string ScipDevice::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (!is_heard()) return {};
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
  if (command == "SCIP2.0") {
    in_version_1_ = false;
    return reply(request.line, "00");
  }
  if (in_version_1_) return request.line + "\nE\n\n";
  if (command == "VV") return reply(request.line, "00", version_lines());
  if (command == "PP") return reply(request.line, "00", scip::parameter_lines(sensor_));
  if (command == "II") return reply(request.line, "00", state_lines(now));
  if (command == "TM") return answer_to_time_request(request, now);
  if (command == "CR" || command == "HS") return reply(request.line, "00");
  if (command == "SS") return answer_to_rate(request);
  if (command == "RB") return answer_to_reboot(request, now);
  if (command == "BM") return answer_to_light(request);
  if (command == "QT" || command == "RS") return answer_to_reset(request, now);
  if (scip::is_stream(command) || scip::is_single(command)) return answer_to_scan_request(request);
  return reply(request.line, "0E");
}

std::string ScipDevice::answer_to_light(const scip::Request& request) {
  if (adjusting_time_) return reply(request.line, "10");
  if (options_.status != "00") return reply(request.line, options_.status);
  const bool was_on = laser_on_;
  laser_on_ = true;
  return reply(request.line, was_on ? "02" : "00");
}

std::string ScipDevice::answer_to_reset(const scip::Request& request, Time now) {
  stream_.reset();
  single_.reset();
  laser_on_ = false;
  std::string answer = reply(request.line, "00");
  if (request.command == "RS") {
    adjusting_time_ = false;
    started_ = now;
    clock_start_ms_ = 0;
    baud_rate_ = options_.baud_rate;
  }
  return answer;
}

std::string ScipDevice::answer_to_rate(const scip::Request& request) {
  const auto rate = scip::parse_decimal(request.parameters);
  if (!rate || request.parameters.size() != 6) return reply(request.line, "01");
  constexpr std::array kRates{19'200, 57'600, 115'200, 250'000, 500'000, 750'000};
  if (std::find(kRates.begin(), kRates.end(), *rate) == kRates.end()) return reply(request.line, "04");
  if (*rate == baud_rate_) return reply(request.line, "03");
  baud_rate_ = *rate;
  return reply(request.line, "00");
}

std::string ScipDevice::answer_to_reboot(const scip::Request& request, Time now) {
  constexpr Duration kConfirm = std::chrono::seconds{1};
  if (!reboot_asked_ || now - *reboot_asked_ > kConfirm) {
    reboot_asked_ = now;
    return reply(request.line, "01");
  }
  const std::string answer = reply(request.line, "00");
  ScipOptions mended = options_;
  mended.status = "00";
  const int line_rate = line_rate_;
  *this = ScipDevice{std::move(mended), now};
  line_rate_ = line_rate;
  return answer;
}

std::string ScipDevice::on_the_line(std::string bytes) const {
  constexpr std::uint8_t kMisread = 0xA6;  // whoever listens at another rate sees other bits
  if (!is_heard()) {
    for (char& byte : bytes) byte = static_cast<char>(byte ^ kMisread);
  }
  return bytes;
}

std::string ScipDevice::answer_to_scan_request(const scip::Request& request) {
  const auto parsed = scip::parse_scan_request(request, sensor_);
  if (const auto* refusal = std::get_if<std::string>(&parsed)) return reply(request.line, *refusal);
  if (adjusting_time_) return reply(request.line, "10");
  if (request.command[1] == 'E' && !options_.has_intensities) return reply(request.line, "0E");
  if (options_.status != "00") return reply(request.line, options_.status);
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
  const Time now = turn_start + turn_period();
  if (now < line_free_) return {};  // the last one is still on the line
  std::string out;
  if (single_) {
    out += scip::bytes_of(scan(*single_, turn_start, measure));
    single_.reset();
  }
  if (stream_ && turns_to_skip_ > 0) {
    --turns_to_skip_;
  } else if (stream_) {
    out += next_of_stream(turn_start, measure);
  }
  constexpr double kBitsPerByte = 10.0;
  if (minds_the_rate()) line_free_ = now + from_seconds(static_cast<double>(out.size()) * kBitsPerByte / baud_rate_);
  return on_the_line(std::move(out));
}

std::string ScipDevice::next_of_stream(Time turn_start, const Measure& measure) {
  turns_to_skip_ = stream_->skip;
  scip::ScanRequest shown = *stream_;
  const bool counted = stream_->count > 0;
  if (counted) --scans_left_;
  shown.count = scans_left_;
  std::string out = scip::bytes_of(scan(shown, turn_start, measure));
  if (counted && scans_left_ == 0) stream_.reset();
  return out;
}

scip::ScanData ScipDevice::scan(const scip::ScanRequest& request, Time turn_start, const Measure& measure) const {
  const int steps = scip::steps_per_value(request);
  std::vector<Beam> beams(scip::value_count(request));
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const int first = request.first_step + static_cast<int>(i) * steps;
    const int last = std::min(first + steps - 1, request.last_step);
    const double middle = 0.5 * (first + last);
    beams[i] = {.angle_rad = scip::angle_of_step(sensor_, middle), .share_of_turn = middle / sensor_.steps_per_turn};
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
          "SBPS:" + (options_.baud_rate != 0 ? std::to_string(baud_rate_) + "[bps]" : "USB only"),
          "TIME:" + scip::timestamp_data(clock_ms(now)),
          std::string{"STAT:"} + (options_.status == "00" ? "Sensor works well." : "Sensor is in trouble.")};
}

std::uint32_t ScipDevice::clock_ms(Time time) const {
  const auto since = (time - started_) / std::chrono::milliseconds{1};
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(clock_start_ms_ + since) & kClockMask);
}

}  // namespace tandem::simulator
