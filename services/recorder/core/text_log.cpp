#include "services/recorder/core/text_log.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace tandem {
namespace {

using carmen::LogError;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) return words;
    line.remove_prefix(start);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// Any number; "nan" and "inf" too.
double number_of(std::string_view word, const std::string& place) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) {
    throw LogError(place + ": \"" + std::string{word.substr(0, 40)} + "\" is not a number");
  }
  return value;
}

double finite_of(std::string_view word, const std::string& place) {
  const double value = number_of(word, place);
  if (!std::isfinite(value)) throw LogError(place + ": a pose or time is not finite");
  return value;
}

/// A scan without time and ranges, and how many ranges it has.
struct Geometry {
  carmen::Scan scan;
  std::size_t count = 0;
};

Geometry geometry_of(const std::vector<std::string_view>& words, const std::string& place) {
  std::map<std::string_view, double> values;
  for (std::size_t i = 2; i + 1 < words.size(); i += 2) {
    if (words[i] != "frame") values[words[i]] = finite_of(words[i + 1], place);
  }
  for (const char* name : {"angle_min", "angle_increment", "n", "range_min", "range_max"}) {
    if (!values.contains(name)) throw LogError(place + ": SCAN_GEOMETRY does not tell " + name);
  }
  if (!(values["n"] >= 1.0 && values["n"] <= 100'000.0)) throw LogError(place + ": n is outside [1, 100000]");
  Geometry geometry;
  geometry.scan.angle_min_rad = values["angle_min"];
  geometry.scan.angle_increment_rad = values["angle_increment"];
  geometry.scan.range_min_m = values["range_min"];
  geometry.scan.range_max_m = values["range_max"];
  geometry.count = static_cast<std::size_t>(values["n"]);
  return geometry;
}

carmen::Scan scan_of(const std::vector<std::string_view>& words, const std::optional<Geometry>& geometry,
                     const std::string& place) {
  if (!geometry) throw LogError(place + ": a scan before any # SCAN_GEOMETRY line");
  if (words.size() != geometry->count + 2) {
    throw LogError(place + ": a scan of " + std::to_string(words.size() - std::min<std::size_t>(2, words.size())) +
                   " ranges, and not " + std::to_string(geometry->count));
  }
  carmen::Scan scan = geometry->scan;
  scan.time_s = finite_of(words[1], place);
  for (std::size_t i = 2; i < words.size(); ++i) {
    const double range_m = number_of(words[i], place);
    const bool returned = range_m >= scan.range_min_m && range_m <= scan.range_max_m;  // NaN is neither
    scan.ranges_m.push_back(returned ? static_cast<float>(range_m) : std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

carmen::Odometry odometry_of(const std::vector<std::string_view>& words, const std::string& place) {
  if (words.size() != 7) throw LogError(place + ": ODOM wants t x y theta v w");
  const auto value = [&](std::size_t i) { return finite_of(words[i], place); };
  return {value(1), {value(2), value(3), wrap_to_pi(value(4))}, {value(5), 0.0, value(6)}};
}

}  // namespace

std::vector<carmen::Event> parse_text_log(std::string_view text, const std::string& file_name,
                                          const Pose2& base_from_laser) {
  std::vector<carmen::Event> events;
  std::optional<Geometry> geometry;
  bool has_scans = false;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::string place = file_name + ":" + std::to_string(++number);
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty()) continue;
    const std::string_view tag = words.front();
    if (tag == "SCAN") {
      carmen::Scan scan = scan_of(words, geometry, place);
      scan.base_from_laser = base_from_laser;
      events.emplace_back(std::move(scan));
      has_scans = true;
    } else if (tag == "ODOM") {
      events.emplace_back(odometry_of(words, place));
    } else if (tag == "#" && words.size() > 1 && words[1] == "SCAN_GEOMETRY") {
      geometry = geometry_of(words, place);
    } else if (!tag.starts_with('#') && tag != "AMCL" && tag != "PERSON" && tag != "LEG") {
      throw LogError(place + ": unknown record \"" + std::string{tag.substr(0, 40)} + "\"");
    }
  }
  if (!has_scans) throw LogError(file_name + ": holds no scan (SCAN line)");
  return events;
}

}  // namespace tandem
