#include "services/recorder/core/carmen_log.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace tandem::carmen {
namespace {

/// Known records without odometry or scans.
constexpr std::array<std::string_view, 8> kIgnored{"PARAM", "NEFF",   "SYNC",   "TRUEPOS",
                                                   "SONAR", "BUMPER", "RLASER", "MARKER"};

/// Recorders wrote lines up to some tenths of a second out of order [s]; an odometry further back has no real time.
constexpr double kLongestStepBack_s = 2.0;

/// The words of one line.
class Words {
 public:
  Words(std::string_view line, std::string place) : rest_(line), place_(std::move(place)) {}

  [[nodiscard]] std::string_view word() {
    const std::size_t start = rest_.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) throw LogError(place_ + ": the line ends too early");
    rest_.remove_prefix(start);
    const std::size_t end = std::min(rest_.find_first_of(" \t\r"), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return found;
  }
  /// Any number; "nan" and "inf" too.
  [[nodiscard]] double number() {
    const std::string_view text = word();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
      throw LogError(place_ + ": \"" + std::string{text} + "\" is not a number");
    }
    return value;
  }
  [[nodiscard]] double finite() {
    const double value = number();
    if (!std::isfinite(value)) throw LogError(place_ + ": a pose or time is not finite");
    return value;
  }
  [[nodiscard]] Pose2 pose() {
    const double x = finite();
    const double y = finite();
    return {x, y, wrap_to_pi(finite())};
  }
  [[nodiscard]] Scan scan();
  [[nodiscard]] const std::string& place() const { return place_; }

 private:
  std::string_view rest_;
  std::string place_;
};

/// What the scanners of these logs report where nothing came back.
bool is_no_return(double range_m) {
  for (const double code : {81.83, 81.91, 50.0, 32.77}) {
    if (std::abs(range_m - code) < 0.005) return true;
  }
  return !(range_m > 0.0) || !std::isfinite(range_m) || (range_m >= 51.0 && range_m < 52.0);
}

/// `n r1..rn`, without the time.
Scan Words::scan() {
  const double count = number();
  Scan scan;
  if (count == 180.0 || count == 181.0) {
    scan.angle_increment_rad = from_degrees(1.0);
  } else if (count == 360.0 || count == 361.0) {
    scan.angle_increment_rad = from_degrees(0.5);
  } else {
    throw LogError(place_ + ": a scan has 180, 181, 360 or 361 beams");
  }
  scan.angle_min_rad = from_degrees(-90.0);
  scan.ranges_m.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double range_m = number();
    scan.ranges_m.push_back(is_no_return(range_m) ? std::numeric_limits<float>::quiet_NaN()
                                                  : static_cast<float>(range_m));
  }
  return scan;
}

/// Takes line after line and gathers the events.
class LogParser {
 public:
  void line(Words words) {
    const std::string_view tag = words.word();
    if (tag == "O") {
      const double time_s = words.finite();
      add(Odometry{time_s, words.pose()});
    } else if (tag == "S") {
      const double time_s = words.finite();
      const Pose2 odom_from_base = words.pose();
      add(time_s, odom_from_base, words.scan());
    } else if (tag == "ODOM") {
      carmen_odometry(words);
    } else if (tag == "FLASER") {
      Scan scan = words.scan();
      (void)words.pose();  // of the laser
      mapped_ = words.pose();
      add(words.finite(), raw_, std::move(scan));
    } else if (!tag.starts_with('#') && std::find(kIgnored.begin(), kIgnored.end(), tag) == kIgnored.end()) {
      throw LogError(words.place() + ": unknown record \"" + std::string{tag.substr(0, 40)} + "\"");
    }
  }
  [[nodiscard]] std::vector<Event> events() && { return std::move(events_); }
  [[nodiscard]] bool has_scans() const { return has_scans_; }

 private:
  void carmen_odometry(Words& words) {
    const Pose2 pose = words.pose();
    for (int i = 0; i < 3; ++i) (void)words.number();  // speed, turn rate, acceleration
    const double time_s = words.finite();
    if (mapped_ == pose) {  // not by its time: some logs have any number there
      base_ = pose;         // the mapper moved the robot, not the wheels
    } else {
      raw_ = base_ ? raw_ * (inverse(*base_) * pose) : pose;
      base_ = pose;
      add(Odometry{time_s, raw_});
    }
    mapped_.reset();
  }
  void add(const Odometry& odometry) {
    newest_s_ = std::max(newest_s_, odometry.time_s);
    if (odometry.time_s < newest_s_ - kLongestStepBack_s) return;
    events_.emplace_back(odometry);
    odometry_time_s_ = odometry.time_s;
  }
  void add(double time_s, const Pose2& odom_from_base, Scan scan) {
    if (odometry_time_s_ != time_s) add(Odometry{time_s, odom_from_base});
    scan.time_s = time_s;
    events_.emplace_back(std::move(scan));
    has_scans_ = true;
  }

  std::vector<Event> events_;
  double newest_s_ = -std::numeric_limits<double>::infinity();
  std::optional<double> odometry_time_s_;  ///< of the last odometry
  bool has_scans_ = false;
  Pose2 raw_;                    ///< CARMEN: the chain so far
  std::optional<Pose2> base_;    ///< CARMEN: the last ODOM pose, on which the next one builds
  std::optional<Pose2> mapped_;  ///< CARMEN: the pose on the scan before, until the next ODOM line
};

}  // namespace

std::vector<Event> parse_log(std::string_view text, const std::string& file_name) {
  LogParser parser;
  std::size_t number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    parser.line(Words{line, file_name + ":" + std::to_string(number)});
  }
  if (!parser.has_scans()) throw LogError(file_name + ": holds no scan (FLASER or S line)");
  return std::move(parser).events();
}

std::string read_log_file(const std::string& file) {
  gzFile stream = gzopen(file.c_str(), "rb");  // reads plain text as it is
  if (stream == nullptr) throw LogError(file + ": cannot be opened");
  std::string text;
  std::array<char, 1 << 16> block{};
  int length = 0;
  while ((length = gzread(stream, block.data(), block.size())) > 0) {
    text.append(block.data(), static_cast<std::size_t>(length));
  }
  const bool damaged = length < 0;
  // gzclose() says whether the last member was whole.
  if (gzclose(stream) != Z_OK || damaged) throw LogError(file + ": the gzip file is damaged or cut short");
  return text;
}

}  // namespace tandem::carmen
