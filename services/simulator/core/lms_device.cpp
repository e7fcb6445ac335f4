#include "services/simulator/core/lms_device.hpp"

#include <algorithm>
#include <cmath>

#include "services/common/angle.hpp"

namespace tandem::simulator {
namespace {

constexpr int kFactoryRate = 9'600;
constexpr std::size_t kConfigBytes = 32;
constexpr std::size_t kStatusBytes = 152;
constexpr std::size_t kFieldAt = 107;
constexpr std::size_t kStepAt = 109;
constexpr double kBitsPerByte = 10.0;

std::string one_byte(std::uint8_t byte) {
  return std::string(1, static_cast<char>(byte));
}

int number_at(const lms::Payload& payload, std::size_t at) {
  return payload[at] | (payload[at + 1] << 8);
}

void put(lms::Payload& payload, std::size_t at, int number) {
  payload[at] = static_cast<std::uint8_t>(number & 0xFF);
  payload[at + 1] = static_cast<std::uint8_t>(number >> 8);
}

}  // namespace

LmsDevice::LmsDevice(LmsOptions options, Time now)
    : options_(std::move(options)), block_(kConfigBytes, 0), baud_rate_(kFactoryRate), line_free_(now) {
  block_ = lms::with_format(block_, {.measuring_mode = 0, .millimetres = true});
}

std::string LmsDevice::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (bytes.empty() || !is_heard()) return {};
  std::string out;
  const std::uint64_t damaged = reader_.damaged();
  for (const lms::Event& event : reader_.take(bytes)) {
    if (event.kind == lms::Event::Kind::Telegram) out += answer(event.payload);
  }
  if (reader_.damaged() != damaged) out += one_byte(lms::kRefused);
  if (!out.empty()) line_free_ = std::max(line_free_, now);
  return out;
}

std::string LmsDevice::answer(const lms::Payload& request) {
  const auto code = request[0];
  lms::Payload payload{static_cast<std::uint8_t>(code | lms::command::kAnswer)};
  switch (code) {
    case lms::command::kReset: {
      const std::string bytes = telegram(payload);
      *this = LmsDevice{options_, line_free_};
      return bytes;
    }
    case lms::command::kType:
      payload.insert(payload.end(), options_.type.begin(), options_.type.end());
      return telegram(payload);
    case lms::command::kStatus:
      return telegram(status_payload());
    case lms::command::kScan:
      single_ = true;
      return one_byte(lms::kAcknowledged);
    case lms::command::kMode:
      return answer_to_mode(request);
    case lms::command::kVariant:
      return answer_to_variant(request);
    case lms::command::kReadConfig:
      payload.insert(payload.end(), block_.begin(), block_.end());
      return telegram(payload);
    case lms::command::kWriteConfig:
      return answer_to_write(request);
    default:
      return one_byte(lms::kRefused);
  }
}

std::string LmsDevice::answer_to_mode(const lms::Payload& request) {
  constexpr std::uint8_t kGood = 0;
  constexpr std::uint8_t kWrongPassword = 1;
  constexpr std::uint8_t kFault = 2;
  lms::Payload payload{lms::command::kMode | lms::command::kAnswer, kGood};
  const std::uint8_t mode = request.size() > 1 ? request[1] : 0xFF;
  if (mode == lms::mode::kInstallation) {
    installing_ = request == lms::mode_request(lms::mode::kInstallation);
    if (!installing_) payload[1] = kWrongPassword;
    return telegram(payload);
  }
  if (const auto rate = lms::rate_of_mode(mode)) {
    const std::string bytes = telegram(payload);  // still at the old rate
    baud_rate_ = *rate;
    return bytes;
  }
  if (mode == lms::mode::kStream || mode == lms::mode::kOnRequest) {
    installing_ = false;
    streaming_ = mode == lms::mode::kStream;
  } else {
    payload[1] = kFault;
  }
  return telegram(payload);
}

std::string LmsDevice::answer_to_variant(const lms::Payload& request) {
  if (request.size() != 5) return one_byte(lms::kRefused);
  const lms::Variant asked{.field_deg = number_at(request, 1), .step_centideg = number_at(request, 3)};
  const bool taken = lms::exists(asked) && !streaming_;
  if (taken) variant_ = asked;
  lms::Payload payload{lms::command::kVariant | lms::command::kAnswer, static_cast<std::uint8_t>(taken ? 1 : 0)};
  payload.insert(payload.end(), request.begin() + 1, request.end());
  return telegram(payload);
}

std::string LmsDevice::answer_to_write(const lms::Payload& request) {
  const bool taken = installing_ && request.size() == block_.size() + 1;
  if (taken) {
    block_.assign(request.begin() + 1, request.end());
    ++flash_writes_;
  }
  lms::Payload payload{lms::command::kWriteConfig | lms::command::kAnswer, static_cast<std::uint8_t>(taken ? 1 : 0)};
  payload.insert(payload.end(), block_.begin(), block_.end());
  return telegram(payload);
}

lms::Payload LmsDevice::status_payload() const {
  lms::Payload payload(kStatusBytes, 0);
  payload[0] = lms::command::kStatus | lms::command::kAnswer;
  put(payload, kFieldAt, variant_.field_deg);
  put(payload, kStepAt, variant_.step_centideg);
  return payload;
}

std::string LmsDevice::telegram(lms::Payload payload) const {
  payload.push_back(options_.polluted ? lms::kPolluted : 0);
  return on_the_line(one_byte(lms::kAcknowledged) + lms::bytes_of(lms::kFromLaser, payload));
}

std::string LmsDevice::on_the_line(std::string bytes) const {
  constexpr std::uint8_t kMisread = 0xA6;  // whoever listens at another rate sees other bits
  if (!is_heard()) {
    for (char& byte : bytes) byte = static_cast<char>(byte ^ kMisread);
  }
  return bytes;
}

std::string LmsDevice::end_turn(Time turn_start, const Measure& measure) {
  if (!announced_) {
    announced_ = true;
    lms::Payload payload{lms::command::kPowerOn};
    payload.insert(payload.end(), options_.type.begin(), options_.type.end());
    payload.push_back(0);
    return on_the_line(lms::bytes_of(lms::kFromLaser, payload));
  }
  const Time now = turn_start + turn_period();
  if (now < line_free_) return {};
  single_ = false;
  const std::string bytes = lms::bytes_of(lms::kFromLaser, lms::payload_of(scan(measure)));
  line_free_ = now + from_seconds(static_cast<double>(bytes.size()) * kBitsPerByte / baud_rate_);
  return on_the_line(bytes);
}

lms::ScanData LmsDevice::scan(const Measure& measure) const {
  const lms::RangeFormat format = lms::format_of(block_);
  std::vector<Beam> beams(lms::value_count(variant_));
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double along_deg = static_cast<double>(i) * variant_.step_centideg * 0.01;
    beams[i] = {.angle_rad = from_degrees(along_deg - variant_.field_deg / 2.0), .share_of_turn = along_deg / 360.0};
  }
  constexpr int kOutOfRange = 8;  // below the greatest number
  const int bits = lms::range_bits(format);
  const auto out_of_range = static_cast<std::uint16_t>((1 << bits) - 1 - kOutOfRange);
  const std::uint16_t strength = lms::has_intensity(format) ? static_cast<std::uint16_t>(1U << bits) : 0;
  lms::ScanData data{.millimetres = format.millimetres, .values = {}, .status = {}};
  data.status = options_.polluted ? lms::kPolluted : 0;
  for (const double range_m : measure(beams)) {
    const bool seen = std::isfinite(range_m) && range_m <= lms::range_max_m(format);
    const double units = seen ? range_m / (format.millimetres ? 0.001 : 0.01) : 0.0;
    data.values.push_back(seen ? static_cast<std::uint16_t>(std::lround(units) | strength) : out_of_range);
  }
  return data;
}

Duration LmsDevice::turn_period() const {
  return from_seconds(lms::turns_per_scan(variant_) * lms::kTurnPeriod_s);
}

}  // namespace tandem::simulator
