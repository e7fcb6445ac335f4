#include "services/simulator/core/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "services/common/file_io.hpp"
#include "services/common/strict_json.hpp"

namespace tandem::simulator {
namespace {

constexpr double kTokenRoom_m = 0.5;
constexpr double kTokenSpacing_m = 0.15;

Pose2 pose(const std::vector<double>& three) {
  return {three[0], three[1], wrap_to_pi(three[2])};
}

std::string text_of(const Eigen::Vector2d& point) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "(" << point.x() << ", " << point.y() << ")";
  return text.str();
}

std::array<Eigen::Vector2d, 3> triangle_around(const Eigen::Vector2d& middle) {
  const double radius = kTokenSpacing_m / std::sqrt(3.0);
  std::array<Eigen::Vector2d, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double angle = from_degrees(90.0 + 120.0 * static_cast<double>(i));
    corners[i] = middle + radius * Eigen::Vector2d{std::cos(angle), std::sin(angle)};
  }
  return corners;
}

bool can_walk(const Place& place, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius_m) {
  return place.has_room(to, radius_m) && !shortest_walk(place, from, to, radius_m).empty();
}

/// The nearest place to the robot's start that leaves it alone: for a person whose own start is a wall of this map.
std::optional<Pose2> person_start_beside(const Place& place, const Pose2& robot_start) {
  constexpr double kApart_m = 1.2;
  for (double distance = kApart_m; distance < 10.0; distance += 0.4) {
    for (int i = 0; i < 16; ++i) {
      const Pose2 turned = robot_start * Pose2{0.0, 0.0, from_degrees(90.0 + 22.5 * i)};
      const Eigen::Vector2d point = turned * Eigen::Vector2d{distance, 0.0};
      if (can_walk(place, robot_start.position(), point, kPersonRoom_m)) {
        return Pose2{point.x(), point.y(), robot_start.heading};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Scenario parse_scenario(std::string_view json, const std::filesystem::path& file) {
  const nlohmann::json document = parse_json(json, file.string());
  StrictObject root{document, file.string()};
  Scenario scenario;
  scenario.name = file.stem().string();
  const std::filesystem::path map = root.text("map");
  scenario.map_file = map.is_absolute() ? map : file.parent_path().parent_path() / map;

  StrictObject robot = root.object("robot");
  scenario.robot_start = pose(robot.numbers("start", 3));
  robot.refuse_unknown_keys();

  StrictObject person = root.object("person");
  scenario.person_start = pose(person.numbers("start", 3));
  scenario.person_model = person.text_or("model", scenario.person_model, {"obedient", "none"});
  person.refuse_unknown_keys();

  StrictObject tokens = root.object("tokens");
  if (tokens.has("at")) {
    const auto at = tokens.numbers("at", 2);
    scenario.tokens_in_map = Eigen::Vector2d{at[0], at[1]};
  }
  scenario.tokens_min_distance_m = tokens.number_or("min_distance_m", scenario.tokens_min_distance_m, {0.0, 1000.0});
  tokens.refuse_unknown_keys();

  scenario.passers_by = root.whole_number_or("passers_by", scenario.passers_by, {0, 50});
  scenario.limit_s = root.number_or("limit_s", scenario.limit_s, {1.0, 36000.0});
  root.refuse_unknown_keys();
  return scenario;
}

Scenario load_scenario(const std::filesystem::path& file) {
  return parse_scenario(read_file(file), file);
}

std::optional<Pose2> robot_start_on(const Place& place, const Pose2& wanted) {
  constexpr double kClearance_m = 1.0;
  const double near_m = place.map().resolution_m();
  const auto ground = place.largest_ground(kRobotRoom_m);
  const auto is_near = [&](const Eigen::Vector2d& point) { return (point - wanted.position()).norm() <= near_m; };
  if (place.has_room(wanted.position(), kRobotRoom_m) && std::any_of(ground.begin(), ground.end(), is_near)) {
    return wanted;
  }
  const auto wide_ground = place.largest_ground(kClearance_m);
  if (wide_ground.empty()) return std::nullopt;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& point : wide_ground) middle += point;
  middle /= static_cast<double>(wide_ground.size());
  const auto nearest = *std::min_element(wide_ground.begin(), wide_ground.end(), [&](const auto& a, const auto& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  });
  return Pose2{nearest.x(), nearest.y(), 0.0};
}

std::optional<Eigen::Vector2d> drawn_token_place(const Place& place, const Pose2& robot_start, double min_distance_m,
                                                 Rng& rng) {
  const auto ground = place.largest_ground(kTokenRoom_m);
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries && !ground.empty(); ++i) {
    const Eigen::Vector2d point = ground[rng.index(ground.size())];
    if ((point - robot_start.position()).norm() <= min_distance_m) continue;
    if (can_walk(place, robot_start.position(), point, kRobotRoom_m)) return point;
  }
  return std::nullopt;
}

Scene scene_of(const Scenario& scenario, const Place& place, MapChoice choice, std::uint64_t seed) {
  Rng rng{seed};
  Scene scene;
  const auto start = robot_start_on(place, scenario.robot_start);
  if (!start || (choice == MapChoice::OwnMap && *start != scenario.robot_start)) {
    throw ConfigError("scenario " + scenario.name + ": the robot has no room at its start " +
                      text_of(scenario.robot_start.position()) + ", or cannot leave it");
  }
  scene.robot_start = *start;

  const bool person_fits = can_walk(place, start->position(), scenario.person_start.position(), kPersonRoom_m);
  const bool moved = *start != scenario.robot_start;
  const auto person = person_fits && !moved ? scenario.person_start : person_start_beside(place, *start);
  if (!person || (choice == MapChoice::OwnMap && !person_fits)) {
    throw ConfigError("scenario " + scenario.name + ": the person has no room at its start " +
                      text_of(scenario.person_start.position()) + ", or cannot leave it");
  }
  scene.person_start = *person;

  auto tokens = scenario.tokens_in_map;
  const bool tokens_fit = tokens && can_walk(place, start->position(), *tokens, kPersonRoom_m);
  if (tokens && choice == MapChoice::OwnMap && !tokens_fit) {
    throw ConfigError("scenario " + scenario.name + ": the tokens cannot be reached at " + text_of(*tokens));
  }
  if (!tokens_fit) tokens = drawn_token_place(place, *start, scenario.tokens_min_distance_m, rng);
  if (!tokens) {
    throw ConfigError("scenario " + scenario.name + ": no free, reachable place for the tokens more than " +
                      std::to_string(std::lround(scenario.tokens_min_distance_m)) + " m from the robot's start");
  }
  scene.tokens_in_map = triangle_around(*tokens);
  return scene;
}

}  // namespace tandem::simulator
