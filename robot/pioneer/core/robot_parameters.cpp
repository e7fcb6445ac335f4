#include "robot/pioneer/core/robot_parameters.hpp"

#include <algorithm>
#include <cctype>

namespace tandem::pioneer {
namespace {

/// One row of the published parameter files, in their units: millimetres and degrees.
constexpr RobotParameters row(std::string_view subclass, double distance, double range, double difference,
                              double radius, double length, double width, double speed, double turn_rate, int sonars,
                              double laser_x, double laser_y, bool skid_steer) {
  return {.subclass = subclass,
          .metres_per_count = distance / 1000.0,
          .metres_per_range = range / 1000.0,
          .half_track_per_m = difference * 1000.0,
          .radius_m = radius / 1000.0,
          .length_m = length / 1000.0,
          .width_m = width / 1000.0,
          .max_speed_mps = speed / 1000.0,
          .max_turn_rate_radps = from_degrees(turn_rate),
          .sonars = sonars,
          .laser_x_m = laser_x / 1000.0,
          .laser_y_m = laser_y / 1000.0,
          .skid_steer = skid_steer};
}

/// A Pioneer 1 counts angles, wheel speeds and VEL2 in units of its own.
constexpr RobotParameters pioneer1(RobotParameters parameters) {
  parameters.radians_per_count = 2.0 * std::numbers::pi / 1024.0;
  parameters.mps_per_count = 2.5332e-3;
  parameters.wheel_speed_step_mmps = 4;
  return parameters;
}

constexpr RobotParameters kTable[] = {
    row("p2at", 1.32, 0.268, 0.0034, 500, 626, 505, 1200, 300, 16, 160, 7, true),
    row("p2at8", 1.32, 1.0, 0.0034, 500, 626, 505, 1200, 300, 16, 160, 7, true),
    row("p2at8+", 0.465, 1.0, 0.0034, 500, 626, 505, 1200, 300, 16, 160, 7, true),
    row("p3at", 0.465, 1.0, 0.0034, 500, 626, 505, 1200, 300, 16, 160, 0, true),
    row("p3at-sh", 1.0, 1.0, 0.0034, 500, 626, 505, 1200, 300, 16, 125, 0, true),
    row("p2dx", 0.84, 0.268, 0.0056, 250, 511, 425, 2200, 500, 16, 17, 8, false),
    row("p2de", 0.969, 0.268, 0.0056, 250, 511, 425, 2200, 500, 16, 17, 8, false),
    row("p2d8", 0.485, 1.0, 0.0056, 250, 511, 425, 2200, 500, 16, 18, 0, false),
    row("p2d8+", 0.485, 1.0, 0.0056, 250, 511, 425, 2200, 500, 16, 18, 0, false),
    row("p3dx", 0.485, 1.0, 0.0056, 250, 511, 425, 2200, 500, 16, 18, 0, false),
    row("p3dx-sh", 1.0, 1.0, 0.0056, 250, 511, 425, 2200, 500, 16, 21, 0, false),
    row("peoplebot-sh", 1.0, 1.0, 0.0060, 340, 513, 425, 2200, 500, 32, 21, 0, false),
    row("powerbot-sh", 1.0, 1.0, 0.00373, 550, 911, 680, 2000, 360, 32, 251, 0, false),
    row("amigo-sh", 1.0, 1.0, 0.0110, 180, 330, 279, 1000, 300, 8, 0, 0, false),
    pioneer1(row("pion1x", 0.05066, 0.1734, 0.00333, 220, 500, 400, 400, 100, 7, 0, 0, false)),
    pioneer1(row("pionat", 0.07, 0.1734, 0.00333, 330, 500, 400, 500, 100, 7, 0, 0, true)),
};

/// A sonar's place on the base, in millimetres and degrees.
constexpr Pose2 sonar(double x, double y, double heading) {
  return {x / 1000.0, y / 1000.0, from_degrees(heading)};
}

constexpr Pose2 kSonarsOfAt[] = {
    sonar(147, 136, 90),    sonar(193, 119, 50),     sonar(227, 79, 30),     sonar(245, 27, 10),
    sonar(245, -27, -10),   sonar(227, -79, -30),    sonar(193, -119, -50),  sonar(147, -136, -90),
    sonar(-144, -136, -90), sonar(-189, -119, -130), sonar(-223, -79, -150), sonar(-241, -27, -170),
    sonar(-241, 27, 170),   sonar(-223, 79, 150),    sonar(-189, 119, 130),  sonar(-144, 136, 90)};
constexpr Pose2 kSonarsOfDx[] = {
    sonar(69, 136, 90),     sonar(114, 119, 50),     sonar(148, 78, 30),     sonar(166, 27, 10),
    sonar(166, -27, -10),   sonar(148, -78, -30),    sonar(114, -119, -50),  sonar(69, -136, -90),
    sonar(-157, -136, -90), sonar(-203, -119, -130), sonar(-237, -78, -150), sonar(-255, -27, -170),
    sonar(-255, 27, 170),   sonar(-237, 78, 150),    sonar(-203, 119, 130),  sonar(-157, 136, 90)};
constexpr Pose2 kSonarsOfAmigo[] = {sonar(70, 100, 90),     sonar(125, 75, 41),   sonar(144, 30, 15),
                                    sonar(144, -30, -15),   sonar(120, -75, -41), sonar(70, -100, -90),
                                    sonar(-146, -58, -145), sonar(-146, 58, 145)};

bool equal_in_any_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char left, unsigned char right) { return std::tolower(left) == std::tolower(right); });
}

}  // namespace

std::span<const RobotParameters> all_robot_parameters() {
  return kTable;
}

std::span<const Pose2> sonar_poses(const RobotParameters& parameters) {
  const std::string_view subclass = parameters.subclass;
  if (subclass == "amigo-sh") return kSonarsOfAmigo;
  if (subclass.starts_with("p2at") || subclass.starts_with("p3at")) return kSonarsOfAt;
  if (subclass.starts_with("p2d") || subclass.starts_with("p3dx")) return kSonarsOfDx;
  return {};
}

const RobotParameters* robot_parameters(std::string_view subclass) {
  const auto* found = std::find_if(std::begin(kTable), std::end(kTable), [&](const RobotParameters& candidate) {
    return equal_in_any_case(candidate.subclass, subclass);
  });
  return found == std::end(kTable) ? nullptr : found;
}

}  // namespace tandem::pioneer
