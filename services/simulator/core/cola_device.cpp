#include "services/simulator/core/cola_device.hpp"

#include <cmath>

#include "services/common/angle.hpp"

namespace tandem::simulator {
namespace {

constexpr std::string_view kUnknown = "sFA 3";  // a name it does not know
constexpr std::string_view kRefused = "sFA 1";  // not without a login
constexpr std::string_view kPassword = "F4724744";
constexpr double kTenthousandths = 1e4;

std::string_view word_at(const cola::Words& words, std::size_t at) {
  return at < words.size() ? std::string_view{words[at]} : std::string_view{};
}

std::string succeeded(std::string_view kind, std::string_view name, bool well) {
  return std::string{kind} + " " + std::string{name} + (well ? " 1" : " 0");
}

}  // namespace

ColaOptions lms111() {
  return {};
}

ColaOptions tim561() {
  return {.identity = "TiM561 V1.0", .is_tim = true, .step_deg = 1.0 / 3.0, .rate_hz = 15.0, .range_max_m = 10.0};
}

ColaDevice::ColaDevice(ColaOptions options, Time now) : options_(std::move(options)), started_(now) {}

std::string ColaDevice::receive(std::span<const std::uint8_t> bytes, Time now) {
  std::string out;
  for (const std::string& text : reader_.take(bytes)) {
    const std::string reply = answer(cola::words_of(text), now);
    if (!reply.empty()) out += cola::bytes_of(reply);
  }
  return out;
}

std::string ColaDevice::answer(const cola::Words& words, Time now) {
  const std::string_view kind = words[0];
  const std::string_view name = word_at(words, 1);
  if (kind == "sRN") return answer_to_read(name, now);
  if (kind == "sMN") return answer_to_method(words);
  if (kind == "sWN" && name == "LMDscandatacfg") return answer_to_content(words);
  if (kind == "sEN" && name == "LMDscandata") {
    streaming_ = word_at(words, 2) == "1";
    return succeeded("sEA", name, streaming_);
  }
  return std::string{kUnknown};
}

std::string ColaDevice::answer_to_read(std::string_view name, Time now) {
  if (name == "DeviceIdent") return "sRA DeviceIdent 10 " + options_.identity;
  if (name == "FirmwareVersion") return "sRA FirmwareVersion 5 1.0.0";
  if (name == "SerialNumber") return "sRA SerialNumber 7 1234567";
  if (name == "STlms" && !options_.is_tim) {
    const int state = !is_ready(now) ? 1 : measuring_ ? 7 : 6;
    return "sRA STlms " + std::to_string(state) + " 0 8 00:00:00 8 01.01.2000 0 0 0";
  }
  if (name == "SCdevicestate" && options_.is_tim) return is_ready(now) ? "sRA SCdevicestate 1" : "sRA SCdevicestate 0";
  if (name == "LMDscandata") {
    single_ = true;  // answered by the next turn
    return {};
  }
  return std::string{kUnknown};
}

std::string ColaDevice::answer_to_method(const cola::Words& words) {
  const std::string_view name = word_at(words, 1);
  if (name == "SetAccessMode") {
    logged_in_ = word_at(words, 2) == "03" && word_at(words, 3) == kPassword;
    return succeeded("sAN", name, logged_in_);
  }
  if ((name == "LMCstartmeas" || name == "LMCstopmeas") && !options_.is_tim) {
    if (!logged_in_) return std::string{kRefused};
    measuring_ = name == "LMCstartmeas";
    return succeeded("sAN", name, false);  // 0: no error
  }
  if (name == "Run") {
    const bool well = logged_in_;
    logged_in_ = false;
    return succeeded("sAN", name, well);
  }
  return std::string{kUnknown};
}

std::string ColaDevice::answer_to_content(const cola::Words& words) {
  constexpr std::size_t kStrengths = 4;
  if (!logged_in_) return std::string{kRefused};
  with_strengths_ = word_at(words, kStrengths) == "1";
  return "sWA LMDscandatacfg";
}

std::string ColaDevice::end_turn(Time turn_start, const Measure& measure) {
  const Time now = turn_start + turn_period();
  if (!is_ready(now) || !measuring_) return {};
  std::string out;
  const cola::ScanData data = scan(turn_start, measure);
  if (single_) out += cola::bytes_of(cola::text_of(data, "sRA"));
  if (streaming_) out += cola::bytes_of(cola::text_of(data, "sSN"));
  single_ = false;
  return out;
}

cola::ScanData ColaDevice::scan(Time turn_start, const Measure& measure) {
  const auto steps =
      static_cast<std::size_t>(std::lround((options_.last_deg - options_.first_deg) / options_.step_deg));
  std::vector<Beam> beams(steps + 1);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double along_deg = static_cast<double>(i) * options_.step_deg;
    constexpr double kAhead_deg = 90.0;
    beams[i] = {.angle_rad = from_degrees(options_.first_deg + along_deg - kAhead_deg),
                .share_of_turn = along_deg / 360.0};
  }
  cola::Channel distances{.name = "DIST1"};
  distances.start_angle = static_cast<std::int32_t>(std::lround(options_.first_deg * kTenthousandths));
  distances.angle_step = static_cast<std::int32_t>(std::lround(options_.step_deg * kTenthousandths));
  cola::Channel strengths = distances;
  strengths.name = "RSSI1";
  constexpr std::uint16_t kStrength = 200;
  for (const double range_m : measure(beams)) {
    const bool seen = std::isfinite(range_m) && range_m <= options_.range_max_m;
    distances.values.push_back(seen ? static_cast<std::uint16_t>(std::lround(range_m * 1000.0)) : 0);
    strengths.values.push_back(seen ? kStrength : 0);
  }
  ++scans_;
  cola::ScanData data{.status = options_.status, .telegram_count = scans_ & 0xFFFF, .scan_count = scans_ & 0xFFFF};
  data.scan_time_us = clock_us(turn_start);
  data.send_time_us = clock_us(turn_start + turn_period());
  data.frequency_centihz = static_cast<std::uint32_t>(std::lround(options_.rate_hz * 100.0));
  data.channels.push_back(std::move(distances));
  if (with_strengths_) data.channels.push_back(std::move(strengths));
  return data;
}

bool ColaDevice::is_ready(Time now) const {
  return now - started_ >= options_.warm_up;
}

std::uint32_t ColaDevice::clock_us(Time time) const {
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>((time - started_) / std::chrono::microseconds{1}));
}

}  // namespace tandem::simulator
