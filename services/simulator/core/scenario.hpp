#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/simulator/core/place.hpp"

namespace tandem::simulator {

/// Radius [m] of the disc that the robot needs: half the diagonal of its hull and a little.
inline constexpr double kRobotRoom_m = 0.45;
/// Radius [m] of the disc that a person needs.
inline constexpr double kPersonRoom_m = 0.25;

/// An episode to be simulated, as written in config/scenarios/*.json.
struct Scenario {
  std::string name;
  std::filesystem::path map_file;                ///< Absolute, or relative to the working folder.
  Pose2 robot_start;                             ///< map_from_base
  Pose2 person_start;                            ///< map_from_person
  std::string person_model = "obedient";         ///< "obedient", or "none": nobody holds a simulated phone.
  std::optional<Eigen::Vector2d> tokens_in_map;  ///< Middle of the three tokens [m]; none: drawn by the seed.
  double tokens_min_distance_m = 10.0;           ///< Of drawn tokens from the robot's start, straight line.
  std::int64_t passers_by = 0;                   ///< People who walk about and do not search.
  double limit_s = 600.0;                        ///< An episode that takes longer has failed.
};

/// The scenario in `json`; `file` stands in messages, and its map is looked for in the folder that holds scenarios/.
/// Throws ConfigError with file and key.
[[nodiscard]] Scenario parse_scenario(std::string_view json, const std::filesystem::path& file);

/// Reads and parses `file`. Throws ConfigError or FileError.
[[nodiscard]] Scenario load_scenario(const std::filesystem::path& file);

/// Whether the scenario's poses were written for the map at hand.
enum class MapChoice { OwnMap, OtherMap };

/// Where everything stands when the episode begins.
struct Scene {
  Pose2 robot_start;
  Pose2 person_start;
  std::array<Eigen::Vector2d, 3> tokens_in_map;  ///< One place: an even triangle, 0.15 m apart.
};

/// The scene of `scenario` on `place`; equal seeds give equal scenes.
///
/// On another map than its own, whatever has no room is moved: see robot_start_on and tokens below. Throws ConfigError
/// if a start of the scenario's own map has no room, or if no place for the tokens exists.
[[nodiscard]] Scene scene_of(const Scenario& scenario, const Place& place, MapChoice choice, std::uint64_t seed);

/// `wanted` if the robot has room there on the largest connected ground; else the point of the largest ground with 1 m
/// of clearance that is nearest to that ground's middle, heading along x. None where no such ground exists.
[[nodiscard]] std::optional<Pose2> robot_start_on(const Place& place, const Pose2& wanted);

/// A place for the tokens: free (0.5 m), reachable for the robot, farther than `min_distance_m` from its start. None if
/// there is none.
[[nodiscard]] std::optional<Eigen::Vector2d> drawn_token_place(const Place& place, const Pose2& robot_start,
                                                               double min_distance_m, Rng& rng);

}  // namespace tandem::simulator
