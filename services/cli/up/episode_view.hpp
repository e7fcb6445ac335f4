#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::cli {

/// A belief as it was last published: value of a cell as a share of the peak, 255 where nothing is searched.
struct BeliefView {
  double resolution_m = 0.0;
  int width = 0;
  int height = 0;
  Eigen::Vector2d origin_in_map{0.0, 0.0};
  std::vector<std::uint8_t> cells;
};

/// What the terminal and the picture show of an episode.
struct EpisodeView {
  std::string phase = "starting";
  double time_s = 0.0;
  double limit_s = 0.0;
  double explored = 0.0;
  double explored_robot = 0.0;
  double explored_human = 0.0;
  std::string role;
  std::string plan;               ///< state of the plan in a word
  std::string robot_state;        ///< moving, or why it stands
  double robot_distance_m = 0.0;  ///< driven
  double human_distance_m = 0.0;  ///< walked, as believed
  std::optional<double> apart_m;  ///< between robot and person
  bool link_up = false;
  double round_trip_ms = 0.0;
  int messages = 0;
  int stops = 0;
  std::optional<OccupancyGrid> map;
  std::optional<BeliefView> belief;
  std::vector<Eigen::Vector2d> robot_track;
  std::vector<Eigen::Vector2d> human_track;
  std::vector<Eigen::Vector2d> robot_plan;
  std::vector<Eigen::Vector2d> human_plan;
  std::optional<Eigen::Vector2d> found_at;
  std::string found_by;
};

/// The view as lines of text, `width` characters at most; with a small map of `map_rows` rows if that is > 0, drawn
/// with ANSI colours.
[[nodiscard]] std::vector<std::string> lines_of(const EpisodeView& view, int width, int map_rows);

/// One line, for logs and for terminals that are none.
[[nodiscard]] std::string summary_line(const EpisodeView& view);

/// The view as a PNG picture: map, belief, both tracks, where the object was.
[[nodiscard]] std::string picture_of(const EpisodeView& view);

}  // namespace tandem::cli
