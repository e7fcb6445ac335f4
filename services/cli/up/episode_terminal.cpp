#include <algorithm>
#include <cmath>
#include <cstdio>

#include "services/cli/up/episode_view.hpp"

namespace tandem::cli {
namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(seconds);
  char text[32];
  std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

std::string bar(double share, int width) {
  const int full = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * width));
  std::string text;
  for (int i = 0; i < width; ++i) text += i < full ? "█" : "░";
  return text;
}

/// An entry of the 256-colour palette.
constexpr int kWall = 238;
constexpr int kUnknown = 233;
constexpr int kSearched = 194;
constexpr int kRobot = 27;
constexpr int kHuman = 28;
constexpr int kFound = 202;
constexpr int kBelief[] = {255, 253, 251, 249, 247, 245};

/// The colour of the square of `side_m` around `point_in_map`: the most telling thing in it.
int colour_of(const EpisodeView& view, const Eigen::Vector2d& point_in_map, double side_m) {
  const double reach = 0.75 * side_m;
  const auto near = [&](const Eigen::Vector2d& other) { return (other - point_in_map).cwiseAbs().maxCoeff() <= reach; };
  if (view.found_at && near(*view.found_at)) return kFound;
  if (!view.robot_track.empty() && near(view.robot_track.back())) return kRobot;
  if (!view.human_track.empty() && near(view.human_track.back())) return kHuman;

  int walls = 0;
  int known = 0;
  constexpr int kProbes = 4;
  for (int i = 0; i < kProbes * kProbes; ++i) {
    const Eigen::Vector2d offset{(i % kProbes + 0.5) / kProbes - 0.5, (i / kProbes + 0.5) / kProbes - 0.5};
    const CellState state = view.map->at(Eigen::Vector2d{point_in_map + side_m * offset});
    walls += state == CellState::Occupied ? 1 : 0;
    known += state != CellState::Unknown ? 1 : 0;
  }
  if (known == 0) return kUnknown;
  if (walls >= 2) return kWall;
  if (view.belief && view.belief->resolution_m > 0.0) {
    const Eigen::Vector2d cell = (point_in_map - view.belief->origin_in_map) / view.belief->resolution_m;
    const int column = static_cast<int>(std::floor(cell.x()));
    const int row = static_cast<int>(std::floor(cell.y()));
    if (column >= 0 && row >= 0 && column < view.belief->width && row < view.belief->height) {
      const std::uint8_t value = view.belief->cells[static_cast<std::size_t>(row * view.belief->width + column)];
      if (value == 255) return 252;
      if (value < 64) return kSearched;
      return kBelief[std::min(5, value / 43)];
    }
  }
  return 255;
}

/// The map in half blocks: two squares a character, one above the other.
std::vector<std::string> map_lines(const EpisodeView& view, int width, int rows) {
  std::vector<std::string> lines;
  if (!view.map || view.map->empty()) return lines;
  const OccupancyGrid& map = *view.map;
  const double width_m = map.width() * map.resolution_m();
  const double height_m = map.height() * map.resolution_m();
  const double side_m = std::max(width_m / width, height_m / (2.0 * rows));
  const int columns = static_cast<int>(std::ceil(width_m / side_m));
  const int squares = static_cast<int>(std::ceil(height_m / side_m));
  for (int top = 0; top < squares; top += 2) {
    std::string line;
    for (int column = 0; column < columns; ++column) {
      const auto colour = [&](int square) {
        return colour_of(
            view, map.map_from_grid() * Eigen::Vector2d{(column + 0.5) * side_m, height_m - (square + 0.5) * side_m},
            side_m);
      };
      line += "\x1b[38;5;" + std::to_string(colour(top)) + ";48;5;" + std::to_string(colour(top + 1)) + "m▀";
    }
    lines.push_back(line + "\x1b[0m");
  }
  return lines;
}

}  // namespace

std::vector<std::string> lines_of(const EpisodeView& view, int width, int map_rows) {
  std::vector<std::string> lines;
  lines.push_back(" Tandem   " + clock_text(view.time_s) + " of " + clock_text(view.limit_s) + "   " + view.phase);
  lines.push_back(" explored " + bar(view.explored, 30) + format(" %3.0f %%", 100.0 * view.explored));
  lines.push_back(format("   robot  %3.0f %%", 100.0 * view.explored_robot) +
                  format("   drove %5.1f m", view.robot_distance_m) + "   " + view.robot_state);
  lines.push_back(format("   person %3.0f %%", 100.0 * view.explored_human) +
                  format("   walked %4.1f m", view.human_distance_m) +
                  (view.apart_m ? format("   %.1f m from the robot", *view.apart_m) : "   not seen yet"));
  lines.push_back(" role     " + (view.role.empty() ? std::string{"-"} : view.role) + "   plan " +
                  (view.plan.empty() ? std::string{"-"} : view.plan));
  lines.push_back(std::string{" link     "} + (view.link_up ? "up" : "LOST") + format(", %.1f ms", view.round_trip_ms) +
                  "   " + std::to_string(view.messages) + " messages   " + std::to_string(view.stops) + " stops");
  if (map_rows > 0) {
    const auto map = map_lines(view, width, map_rows);
    lines.insert(lines.end(), map.begin(), map.end());
    lines.push_back(
        " \x1b[38;5;27m█\x1b[0m robot  \x1b[38;5;28m█\x1b[0m person  \x1b[38;5;194m█\x1b[0m searched"
        "  \x1b[38;5;245m█\x1b[0m likely here  \x1b[38;5;202m█\x1b[0m found");
  }
  return lines;
}

std::string summary_line(const EpisodeView& view) {
  char text[256];
  std::snprintf(text, sizeof text, "%s %s  explored %.0f %% (robot %.0f, person %.0f)  %s  plan %s  link %s  robot %s",
                clock_text(view.time_s).c_str(), view.phase.c_str(), 100.0 * view.explored, 100.0 * view.explored_robot,
                100.0 * view.explored_human, view.role.empty() ? "-" : view.role.c_str(),
                view.plan.empty() ? "-" : view.plan.c_str(), view.link_up ? "up" : "lost", view.robot_state.c_str());
  return text;
}

}  // namespace tandem::cli
