#include "robot/laser/core/cola_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "services/common/angle.hpp"

namespace tandem::cola {
namespace {

constexpr std::string_view kName = "LMDscandata";
constexpr std::size_t kMostChannels = 16;
constexpr std::size_t kMostValues = 10'000;
constexpr std::size_t kMostEncoders = 8;
constexpr double kCodes_m = 0.02;  // below: dazzle and error codes

/// Reads word after word; after the first that is missing or wrong nothing is good any more.
class WordReader {
 public:
  explicit WordReader(const Words& words) : words_(words) {}

  [[nodiscard]] std::string word() {
    if (at_ < words_.size()) return words_[at_++];
    good_ = false;
    return {};
  }
  [[nodiscard]] std::int64_t number(std::int64_t most = std::numeric_limits<std::uint32_t>::max()) {
    const auto value = parse_number(word());
    if (value && *value >= 0 && *value <= most) return *value;
    good_ = false;
    return 0;
  }
  [[nodiscard]] std::uint32_t count32() { return static_cast<std::uint32_t>(number()); }
  [[nodiscard]] std::int32_t signed_number() { return kept(parse_signed(word())); }
  [[nodiscard]] float real() { return kept(parse_float(word())); }
  void skip(std::size_t words) {
    for (std::size_t i = 0; i < words && good_; ++i) (void)word();
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  template <typename T>
  T kept(const std::optional<T>& value) {
    if (!value) good_ = false;
    return value.value_or(T{});
  }

  const Words& words_;
  std::size_t at_ = 0;
  bool good_ = true;
};

void read_channels(WordReader& words, std::int64_t most_value, std::vector<Channel>& channels) {
  const auto count = static_cast<std::size_t>(words.number(kMostChannels));
  for (std::size_t i = 0; i < count && words.good(); ++i) {
    Channel channel;
    channel.name = words.word();
    channel.scale = words.real();
    channel.offset = words.real();
    channel.start_angle = words.signed_number();
    channel.angle_step = words.signed_number();
    const auto values = static_cast<std::size_t>(words.number(kMostValues));
    for (std::size_t k = 0; k < values && words.good(); ++k) {
      channel.values.push_back(static_cast<std::uint16_t>(words.number(most_value)));
    }
    channels.push_back(std::move(channel));
  }
}

bool is_short(const Channel& channel) {
  return channel.name.starts_with("RSSI") &&
         std::all_of(channel.values.begin(), channel.values.end(), [](std::uint16_t value) { return value <= 0xFF; });
}

void write_channels(const std::vector<Channel>& channels, bool short_ones, std::string& text) {
  const auto is_ours = [short_ones](const Channel& channel) { return is_short(channel) == short_ones; };
  text += " " + hexadecimal(static_cast<std::uint32_t>(std::count_if(channels.begin(), channels.end(), is_ours)));
  for (const Channel& channel : channels) {
    if (!is_ours(channel)) continue;
    text += " " + channel.name + " " + hexadecimal_float(channel.scale) + " " + hexadecimal_float(channel.offset);
    text += " " + hexadecimal(static_cast<std::uint32_t>(channel.start_angle));
    text += " " + hexadecimal(static_cast<std::uint32_t>(channel.angle_step));
    text += " " + hexadecimal(static_cast<std::uint32_t>(channel.values.size()));
    for (const std::uint16_t value : channel.values) text += " " + hexadecimal(value);
  }
}

const Channel* channel_named(const ScanData& scan, std::string_view name) {
  const auto found = std::find_if(scan.channels.begin(), scan.channels.end(),
                                  [name](const Channel& channel) { return channel.name == name; });
  return found == scan.channels.end() ? nullptr : &*found;
}

double angle_rad(std::int32_t tenthousandths) {
  return from_degrees(tenthousandths * 1e-4);
}

}  // namespace

std::optional<ScanData> parse_scan(std::string_view text) {
  const Words all = words_of(text);
  WordReader words{all};
  const std::string kind = words.word();
  if ((kind != "sSN" && kind != "sRA") || words.word() != kName) return std::nullopt;
  ScanData scan;
  words.skip(4);  // version, device, serial number, first status word
  scan.status = static_cast<int>(words.number(0xFF));
  scan.telegram_count = words.count32();
  scan.scan_count = words.count32();
  scan.scan_time_us = words.count32();
  scan.send_time_us = words.count32();
  words.skip(5);  // inputs, outputs, layer
  scan.frequency_centihz = words.count32();
  words.skip(1);  // measurement frequency
  const auto encoders = static_cast<std::size_t>(words.number(kMostEncoders));
  words.skip(2 * encoders);
  read_channels(words, 0xFFFF, scan.channels);
  read_channels(words, 0xFF, scan.channels);
  if (!words.good()) return std::nullopt;
  return scan;
}

std::string text_of(const ScanData& scan, std::string_view kind) {
  std::string text{kind};
  text += " LMDscandata 1 1 1234567 0 " + hexadecimal(static_cast<std::uint32_t>(scan.status));
  for (const std::uint32_t number : {scan.telegram_count, scan.scan_count, scan.scan_time_us, scan.send_time_us}) {
    text += " " + hexadecimal(number);
  }
  text += " 0 0 0 0 0 " + hexadecimal(scan.frequency_centihz) + " 21C 0";
  write_channels(scan.channels, false, text);
  write_channels(scan.channels, true, text);
  return text + " 0 0 0 0 0";
}

std::optional<DeviceScan> device_scan_of(const ScanData& scan, double range_max_m) {
  const Channel* distances = channel_named(scan, "DIST1");
  if (distances == nullptr || distances->values.size() < 2 || distances->angle_step <= 0 ||
      scan.frequency_centihz == 0) {
    return std::nullopt;
  }
  DeviceScan out;
  LaserReading& reading = out.reading;
  reading.scan_period_s = 100.0 / scan.frequency_centihz;
  reading.angle_min_rad = angle_rad(distances->start_angle) - std::numbers::pi / 2.0;
  reading.angle_increment_rad = angle_rad(distances->angle_step);
  reading.beam_interval_s = reading.scan_period_s * reading.angle_increment_rad / (2.0 * std::numbers::pi);
  reading.range_min_m = kCodes_m;
  reading.range_max_m = range_max_m;
  for (const std::uint16_t value : distances->values) {
    const double range_m = (value * static_cast<double>(distances->scale) + distances->offset) * 0.001;
    const bool usable = value != 0 && range_m >= kCodes_m && range_m <= range_max_m;
    reading.ranges_m.push_back(usable ? static_cast<float>(range_m) : std::numeric_limits<float>::quiet_NaN());
  }
  if (const Channel* strengths = channel_named(scan, "RSSI1");
      strengths != nullptr && strengths->values.size() == distances->values.size()) {
    for (const std::uint16_t value : strengths->values) {
      reading.intensities.push_back(static_cast<float>(value) * strengths->scale + strengths->offset);
    }
  }
  // The clock at the sending is the mark: what the device needs before varies, and it says so.
  out.clock = scan.send_time_us;
  out.clock_format = {.tick = std::chrono::microseconds{1}, .most = 0xFFFFFFFF};
  out.mark_to_first_beam = -std::chrono::microseconds{scan.send_time_us - scan.scan_time_us};
  out.period_s = reading.scan_period_s;
  return out;
}

std::string complaint_of(int status) {
  switch (status) {
    case 0:
      return "";
    case 2:
      return "the laser says that its window is getting dirty: clean it";
    case 4:
    case 5:
      return "the laser says that its window is dirty: clean it";
    default:
      return "the laser reports an error (status " + std::to_string(status) + ")";
  }
}

}  // namespace tandem::cola
