#include <algorithm>
#include <cmath>

#include "services/cli/up/episode_view.hpp"
#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(seconds);
  return formatted("%d:%02d", whole / 60, whole % 60);
}

/// An entry of the 256-colour palette; the hues are those of the phone's page.
constexpr int kBlank = 233;
constexpr int kWall = 238;
constexpr int kFloor = 255;  ///< nothing is searched here
constexpr int kSearched = 194;
constexpr int kRobot = 26;
constexpr int kRobotPath = 33;
constexpr int kPerson = 28;
constexpr int kPersonPath = 208;
constexpr int kFound = 160;
constexpr int kBelief[] = {189, 189, 183, 183, 140, 140};  ///< from hardly to most likely

std::string foreground(int colour) {
  return "\x1b[38;5;" + std::to_string(colour) + "m";
}
std::string background(int colour) {
  return "\x1b[48;5;" + std::to_string(colour) + "m";
}
constexpr const char* kPlain = "\x1b[0m";

std::string repeated(const char* character, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += character;
  return text;
}

/// What the robot has searched, then what the person has, then what is left.
std::string bar_of(const EpisodeView& view, int width) {
  const auto length = [&](double share) { return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * width)); };
  const int all = length(view.explored);
  const int robot = std::min(all, length(view.explored_robot));
  const int person = std::min(all - robot, length(view.explored_human));
  return foreground(kRobotPath) + repeated("█", robot) + foreground(kPerson) + repeated("█", person) + foreground(250) +
         repeated("█", all - robot - person) + foreground(240) + repeated("░", width - all) + kPlain;
}

/// The map as squares, from its upper left corner; two of them, one above the other, make a character.
class MapSquares {
 public:
  MapSquares(const OccupancyGrid& map, int width, int rows) : map_(map) {
    const double width_m = map.width() * map.resolution_m();
    height_m_ = map.height() * map.resolution_m();
    side_m_ = std::max(width_m / width, height_m_ / (2.0 * rows));
    columns_ = static_cast<int>(std::ceil(width_m / side_m_ - 1e-6));
    rows_ = static_cast<int>(std::ceil(height_m_ / (2.0 * side_m_) - 1e-6));
    colours_.assign(static_cast<std::size_t>(2 * columns_ * rows_), kBlank);
  }

  void draw_ground(const std::optional<BeliefView>& belief) {
    for (int square = 0; square < 2 * rows_; ++square) {
      for (int column = 0; column < columns_; ++column) {
        const Eigen::Vector2d in_grid{(column + 0.5) * side_m_, height_m_ - (square + 0.5) * side_m_};
        colour_at(column, square) = ground_at(map_.map_from_grid() * in_grid, belief);
      }
    }
  }

  void draw_path(const std::vector<Eigen::Vector2d>& points_in_map, int colour) {
    for (std::size_t i = 1; i < points_in_map.size(); ++i) {
      const Eigen::Vector2d leg = points_in_map[i] - points_in_map[i - 1];
      const int steps = std::max(1, static_cast<int>(std::ceil(leg.norm() / (0.5 * side_m_))));
      for (int step = 0; step <= steps; ++step) {
        const auto [column, square] = square_of(points_in_map[i - 1] + leg * step / steps);
        if (is_inside(column, square)) colour_at(column, square) = colour;
      }
    }
  }

  /// A letter on a coloured sign of three characters.
  void draw_sign(const Eigen::Vector2d& point_in_map, char letter, int colour) {
    const auto [column, square] = square_of(point_in_map);
    if (is_inside(column, square))
      signs_.push_back({std::clamp(column - 1, 0, std::max(0, columns_ - 3)), square / 2, letter, colour});
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (int row = 0; row < rows_; ++row) {
      std::string line;
      for (int column = 0; column < columns_; ++column) {
        // The newest sign lies on top.
        const auto sign = std::find_if(signs_.rbegin(), signs_.rend(), [&](const Sign& one) {
          return one.row == row && one.column <= column && column < one.column + 3;
        });
        if (sign == signs_.rend()) {
          line += foreground(colour_at(column, 2 * row)) + background(colour_at(column, 2 * row + 1)) + "▀";
        } else {
          line += foreground(231) + background(sign->colour) + "\x1b[1m";
          line += column == sign->column + 1 ? sign->letter : ' ';
          line += "\x1b[22m";
        }
      }
      lines.push_back(line + kPlain);
    }
    return lines;
  }

 private:
  struct Sign {
    int column = 0;
    int row = 0;
    char letter = ' ';
    int colour = 0;
  };

  int& colour_at(int column, int square) { return colours_[static_cast<std::size_t>(square * columns_ + column)]; }
  [[nodiscard]] int colour_at(int column, int square) const {
    return colours_[static_cast<std::size_t>(square * columns_ + column)];
  }
  [[nodiscard]] bool is_inside(int column, int square) const {
    return column >= 0 && column < columns_ && square >= 0 && square < 2 * rows_;
  }
  [[nodiscard]] std::pair<int, int> square_of(const Eigen::Vector2d& point_in_map) const {
    const Eigen::Vector2d in_grid = inverse(map_.map_from_grid()) * point_in_map;
    return {static_cast<int>(std::floor(in_grid.x() / side_m_)),
            static_cast<int>(std::floor((height_m_ - in_grid.y()) / side_m_))};
  }

  /// Wall, floor, or how likely the object is there.
  [[nodiscard]] int ground_at(const Eigen::Vector2d& point_in_map, const std::optional<BeliefView>& belief) const {
    int walls = 0;
    int known = 0;
    constexpr int kProbes = 4;
    for (int i = 0; i < kProbes * kProbes; ++i) {
      const Eigen::Vector2d offset{(i % kProbes + 0.5) / kProbes - 0.5, (i / kProbes + 0.5) / kProbes - 0.5};
      const CellState state = map_.at(Eigen::Vector2d{point_in_map + side_m_ * offset});
      walls += state == CellState::Occupied ? 1 : 0;
      known += state != CellState::Unknown ? 1 : 0;
    }
    if (known == 0) return kBlank;
    if (walls >= 2) return kWall;
    if (!belief || belief->resolution_m <= 0.0) return kFloor;
    const Eigen::Vector2d cell = (point_in_map - belief->origin_in_map) / belief->resolution_m;
    const int column = static_cast<int>(std::floor(cell.x()));
    const int row = static_cast<int>(std::floor(cell.y()));
    if (column < 0 || row < 0 || column >= belief->width || row >= belief->height) return kFloor;
    const std::uint8_t value = belief->cells[static_cast<std::size_t>(row * belief->width + column)];
    if (value == 255) return kFloor;
    return value < 64 ? kSearched : kBelief[std::min(5, value / 43)];
  }

  const OccupancyGrid& map_;
  double height_m_ = 0.0;
  double side_m_ = 0.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> colours_;
  std::vector<Sign> signs_;
};

std::vector<std::string> map_lines(const EpisodeView& view, int width, int rows) {
  if (!view.map || view.map->empty()) return {};
  MapSquares squares{*view.map, width, rows};
  squares.draw_ground(view.belief);
  squares.draw_path(view.human_plan, kPersonPath);
  squares.draw_path(view.robot_plan, kRobotPath);
  if (view.found_at) squares.draw_sign(*view.found_at, '*', kFound);
  if (!view.human_track.empty()) squares.draw_sign(view.human_track.back(), 'P', kPerson);
  if (!view.robot_track.empty()) squares.draw_sign(view.robot_track.back(), 'R', kRobot);
  return squares.lines();
}

std::string legend() {
  const auto sign = [](char letter, int colour, const char* meaning) {
    return background(colour) + foreground(231) + "\x1b[1m " + letter + " " + kPlain + " " + meaning + "  ";
  };
  const auto square = [](int colour) { return foreground(colour) + "█" + kPlain; };
  return " " + sign('R', kRobot, "robot") + sign('P', kPerson, "person") + square(kRobotPath) + square(kPersonPath) +
         " paths  " + square(kSearched) + " searched  " + square(kBelief[5]) + " likely  " + sign('*', kFound, "found");
}

}  // namespace

std::vector<std::string> lines_of(const EpisodeView& view, int width, int map_rows) {
  std::vector<std::string> lines;
  lines.push_back(" \x1b[1mTandem\x1b[0m   " + clock_text(view.time_s) + " of " + clock_text(view.limit_s) + "   " +
                  view.phase);
  lines.push_back(" explored " + bar_of(view, 50) + formatted(" %3.0f %%", 100.0 * view.explored));
  lines.push_back(formatted("   robot  %3.0f %%", 100.0 * view.explored_robot) +
                  formatted("   drove %5.1f m", view.robot_distance_m) + "   " + view.robot_state);
  lines.push_back(formatted("   person %3.0f %%", 100.0 * view.explored_human) +
                  formatted("   walked %4.1f m", view.human_distance_m) +
                  (view.apart_m ? formatted("   %.1f m from the robot", *view.apart_m) : "   not seen yet"));
  lines.push_back(" role     " + (view.role.empty() ? std::string{"-"} : view.role) + "   plan " +
                  (view.plan.empty() ? std::string{"-"} : view.plan));
  lines.push_back(std::string{" link     "} + (view.link_up ? "up" : "LOST") +
                  formatted(", %.1f ms", view.round_trip_ms) + "   " + std::to_string(view.messages) + " messages   " +
                  std::to_string(view.stops) + " stops");
  if (map_rows > 0) {
    const auto map = map_lines(view, width, map_rows);
    lines.insert(lines.end(), map.begin(), map.end());
    lines.push_back(legend());
  }
  return lines;
}

std::string summary_line(const EpisodeView& view) {
  return formatted("%s %s  explored %.0f %% (robot %.0f, person %.0f)  %s  plan %s  link %s  robot %s",
                   clock_text(view.time_s).c_str(), view.phase.c_str(), 100.0 * view.explored,
                   100.0 * view.explored_robot, 100.0 * view.explored_human,
                   view.role.empty() ? "-" : view.role.c_str(), view.plan.empty() ? "-" : view.plan.c_str(),
                   view.link_up ? "up" : "lost", view.robot_state.c_str());
}

}  // namespace tandem::cli
