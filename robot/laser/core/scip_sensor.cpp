#include "robot/laser/core/scip_sensor.hpp"

#include <numbers>
#include <string_view>
#include <utility>

#include "robot/laser/core/scip_encoding.hpp"

namespace tandem::scip {
namespace {

/// Each number of PP with its key, for reading and writing alike.
template <typename Parameters, typename Visit>
void for_each_number(Parameters& sensor, Visit&& visit) {
  visit("DMIN:", sensor.range_min_mm);
  visit("DMAX:", sensor.range_max_mm);
  visit("ARES:", sensor.steps_per_turn);
  visit("AMIN:", sensor.first_step);
  visit("AMAX:", sensor.last_step);
  visit("AFRT:", sensor.front_step);
  visit("SCAN:", sensor.turns_per_minute);
}

constexpr std::string_view kModel = "MODL:";

/// The value of the line that begins with `key`.
std::optional<std::string> value_of(const std::vector<std::string>& lines, std::string_view key) {
  for (const std::string& line : lines) {
    if (line.starts_with(key)) return line.substr(key.size());
  }
  return std::nullopt;
}

bool makes_sense(const SensorParameters& sensor) {
  return sensor.steps_per_turn > 0 && sensor.last_step > sensor.first_step && sensor.turns_per_minute > 0 &&
         sensor.range_max_mm > sensor.range_min_mm && sensor.last_step - sensor.first_step <= sensor.steps_per_turn;
}

}  // namespace

SensorParameters utm_30lx() {
  return {.model = "UTM-30LX",
          .range_min_mm = 23,
          .range_max_mm = 60'000,
          .steps_per_turn = 1440,
          .first_step = 0,
          .last_step = 1080,
          .front_step = 540,
          .turns_per_minute = 2400};
}

SensorParameters urg_04lx() {
  return {.model = "URG-04LX",
          .range_min_mm = 20,
          .range_max_mm = 5600,
          .steps_per_turn = 1024,
          .first_step = 44,
          .last_step = 725,
          .front_step = 384,
          .turns_per_minute = 600};
}

SensorParameters ust_10lx() {
  SensorParameters sensor = utm_30lx();
  sensor.model = "UST-10LX";
  sensor.range_min_mm = 20;
  sensor.range_max_mm = 30'000;
  return sensor;
}

SensorParameters ust_20lx() {
  SensorParameters sensor = ust_10lx();
  sensor.model = "UST-20LX";
  sensor.range_max_mm = 60'000;
  return sensor;
}

std::vector<std::string> parameter_lines(const SensorParameters& sensor) {
  std::vector<std::string> lines{std::string{kModel} + sensor.model};
  for_each_number(sensor, [&lines](std::string_view key, int number) {
    lines.push_back(std::string{key} + std::to_string(number));
  });
  return lines;
}

std::optional<SensorParameters> parse_parameters(const std::vector<std::string>& lines) {
  SensorParameters sensor;
  bool complete = true;
  for_each_number(sensor, [&](std::string_view key, int& number) {
    const auto text = value_of(lines, key);
    const auto value = text ? parse_decimal(*text) : std::nullopt;
    complete = complete && value;
    number = value.value_or(0);
  });
  if (!complete || !makes_sense(sensor)) return std::nullopt;
  sensor.model = value_of(lines, kModel).value_or("");
  return sensor;
}

double angle_of_step(const SensorParameters& sensor, double step) {
  return (step - sensor.front_step) * 2.0 * std::numbers::pi / sensor.steps_per_turn;
}

double turn_period_s(const SensorParameters& sensor) {
  return 60.0 / sensor.turns_per_minute;
}

}  // namespace tandem::scip
