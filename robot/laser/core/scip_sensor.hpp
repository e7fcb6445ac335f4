#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tandem::scip {

/// What a sensor says of itself (PP); angles are counted in steps, counter-clockwise, seen from above.
struct SensorParameters {
  std::string model;
  int range_min_mm = 0;      ///< DMIN: a smaller value is an error code, not a distance.
  int range_max_mm = 0;      ///< DMAX: a greater value means that nothing came back.
  int steps_per_turn = 0;    ///< ARES
  int first_step = 0;        ///< AMIN
  int last_step = 0;         ///< AMAX
  int front_step = 0;        ///< AFRT: the step that looks straight ahead.
  int turns_per_minute = 0;  ///< SCAN

  friend bool operator==(const SensorParameters&, const SensorParameters&) = default;
};

/// The UTM-30LX: 270 degrees in steps of 0.25, 40 turns per second, 30 m.
[[nodiscard]] SensorParameters utm_30lx();
/// The URG-04LX: 240 degrees, 10 turns per second, 5.6 m.
[[nodiscard]] SensorParameters urg_04lx();

/// The UST-10LX and UST-20LX: as the UTM-30LX, over Ethernet; 10 m and 20 m rated, of which they tell more.
[[nodiscard]] SensorParameters ust_10lx();
[[nodiscard]] SensorParameters ust_20lx();

/// The data lines of the answer to PP ("KEY:value"), without the ';' and checksum that end them on the wire.
[[nodiscard]] std::vector<std::string> parameter_lines(const SensorParameters& sensor);
/// The inverse; none if a key is missing or the numbers make no sense together.
[[nodiscard]] std::optional<SensorParameters> parse_parameters(const std::vector<std::string>& lines);

/// Direction of `step` [rad] in the laser frame, x ahead; a half step lies between two.
[[nodiscard]] double angle_of_step(const SensorParameters& sensor, double step);
/// From one pass of the index mark to the next [s].
[[nodiscard]] double turn_period_s(const SensorParameters& sensor);

}  // namespace tandem::scip
