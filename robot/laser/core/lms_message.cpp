#include "robot/laser/core/lms_message.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace tandem::lms {
namespace {

constexpr std::array<std::pair<int, std::uint8_t>, 4> kRates{{
    {38'400, 0x40},
    {19'200, 0x41},
    {9'600, 0x42},
    {500'000, 0x48},
}};

constexpr std::size_t kMeasuringMode = 5;  // in the block; one more in the payload
constexpr std::size_t kUnit = 6;

constexpr std::uint16_t kCount = 0x03FF;
constexpr std::uint16_t kPartial = 0x2000;
constexpr int kUnitShift = 14;

void append(Payload& payload, int number) {
  payload.push_back(static_cast<std::uint8_t>(number & 0xFF));
  payload.push_back(static_cast<std::uint8_t>((number >> 8) & 0xFF));
}

}  // namespace

std::optional<std::uint8_t> mode_of_rate(int baud_rate) {
  for (const auto& [rate, mode] : kRates) {
    if (rate == baud_rate) return mode;
  }
  return std::nullopt;
}

std::optional<int> rate_of_mode(std::uint8_t wanted) {
  for (const auto& [rate, mode] : kRates) {
    if (mode == wanted) return rate;
  }
  return std::nullopt;
}

bool exists(const Variant& variant) {
  if (variant.field_deg != 180 && variant.field_deg != 100) return false;
  if (variant.step_centideg == 25) return variant.field_deg == 100;
  return variant.step_centideg == 50 || variant.step_centideg == 100;
}

std::size_t value_count(const Variant& variant) {
  return static_cast<std::size_t>(variant.field_deg * 100 / variant.step_centideg) + 1;
}

int turns_per_scan(const Variant& variant) {
  return 100 / variant.step_centideg;
}

int range_bits(const RangeFormat& format) {
  switch (format.measuring_mode) {
    case 3:
    case 4:
      return 14;
    case 5:
    case 6:
      return 15;
    case 0x0F:
      return 16;
    default:
      return 13;
  }
}

bool has_intensity(const RangeFormat& format) {
  return format.measuring_mode == 1 || format.measuring_mode == 3 || format.measuring_mode == 5;
}

double range_max_m(const RangeFormat& format) {
  constexpr int kErrorCodes = 9;  // from "out of range" to "not valid"
  const int greatest = (1 << range_bits(format)) - 1 - kErrorCodes;
  return greatest * (format.millimetres ? 0.001 : 0.01);
}

RangeFormat format_of(const ConfigBlock& block) {
  assert(block.size() >= kLeastConfigBlock);
  return {.measuring_mode = block[kMeasuringMode], .millimetres = block[kUnit] == 1};
}

ConfigBlock with_format(ConfigBlock block, const RangeFormat& format) {
  assert(block.size() >= kLeastConfigBlock);
  block[kMeasuringMode] = format.measuring_mode;
  block[kUnit] = format.millimetres ? 1 : 0;
  return block;
}

Payload mode_request(std::uint8_t mode) {
  Payload payload{command::kMode, mode};
  if (mode != mode::kInstallation) return payload;
  for (const char letter : kPassword) payload.push_back(static_cast<std::uint8_t>(letter));
  return payload;
}

Payload variant_request(const Variant& variant) {
  Payload payload{command::kVariant};
  append(payload, variant.field_deg);
  append(payload, variant.step_centideg);
  return payload;
}

std::optional<ScanData> parse_scan(const Payload& payload) {
  if (payload.size() < 4 || payload[0] != (command::kScan | command::kAnswer)) return std::nullopt;
  const auto header = static_cast<std::uint16_t>(payload[1] | (payload[2] << 8));
  const std::size_t count = header & kCount;
  const int unit = header >> kUnitShift;
  const std::size_t least = 3 + 2 * count + 1;  // some lasers add a byte or two before the status
  if (count == 0 || (header & kPartial) != 0 || unit > 1 || payload.size() < least || payload.size() > least + 2) {
    return std::nullopt;
  }
  ScanData scan{.millimetres = unit == 1, .values = {}, .status = payload.back()};
  scan.values.reserve(count);
  for (std::size_t at = 3; at < 3 + 2 * count; at += 2) {
    scan.values.push_back(static_cast<std::uint16_t>(payload[at] | (payload[at + 1] << 8)));
  }
  return scan;
}

Payload payload_of(const ScanData& scan) {
  Payload payload{command::kScan | command::kAnswer};
  append(payload, static_cast<int>(scan.values.size()) | ((scan.millimetres ? 1 : 0) << kUnitShift));
  for (const std::uint16_t value : scan.values) append(payload, value);
  payload.push_back(scan.status);
  return payload;
}

std::string complaint_of(std::uint8_t status) {
  constexpr std::uint8_t kLevel = 0x07;
  if ((status & kPolluted) != 0) return "the laser says that its window is dirty: clean it";
  switch (status & kLevel) {
    case 3:
      return "the laser reports an error";
    case 4:
      return "the laser reports a fatal error: switch it off and on";
    default:
      return "";
  }
}

}  // namespace tandem::lms
