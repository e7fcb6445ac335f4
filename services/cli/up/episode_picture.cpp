#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "services/cli/up/episode_view.hpp"
#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

// Okabe-Ito hues, which colour-blind people tell apart; OpenCV wants blue, green, red.
const cv::Scalar kRobot{178, 114, 0};
const cv::Scalar kHuman{51, 119, 17};
const cv::Scalar kFound{0, 94, 213};
const cv::Scalar kText{30, 30, 30};
constexpr int kFooter_px = 64;

class Picture {
 public:
  explicit Picture(const OccupancyGrid& map)
      : map_(map),
        scale_(std::clamp(1100.0 / std::max(1, std::max(map.width(), map.height())), 1.0, 16.0)),
        height_px_(static_cast<int>(map.height() * scale_)),
        image_(height_px_ + kFooter_px, std::max(640, static_cast<int>(map.width() * scale_)), CV_8UC3,
               cv::Scalar{255, 255, 255}) {}

  [[nodiscard]] cv::Point at(const Eigen::Vector2d& point_in_map) const {
    const Eigen::Vector2d cells = map_.in_cells(point_in_map);
    return {static_cast<int>(cells.x() * scale_), height_px_ - static_cast<int>(cells.y() * scale_)};
  }

  void draw_ground(const std::optional<BeliefView>& belief) {
    for (int y = 0; y < height_px_; ++y) {
      for (int x = 0; x < static_cast<int>(map_.width() * scale_); ++x) {
        const CellIndex cell{static_cast<int>(x / scale_), static_cast<int>((height_px_ - 1 - y) / scale_)};
        image_.at<cv::Vec3b>(y, x) = colour(cell, belief);
      }
    }
  }

  void draw_track(const std::vector<Eigen::Vector2d>& track, const cv::Scalar& colour) {
    for (const int thickness : {6, 3}) {
      for (std::size_t i = 1; i < track.size(); ++i) {
        cv::line(image_, at(track[i - 1]), at(track[i]), thickness == 6 ? cv::Scalar{255, 255, 255} : colour, thickness,
                 cv::LINE_AA);
      }
    }
    if (track.empty()) return;
    cv::circle(image_, at(track.front()), 6, colour, 2, cv::LINE_AA);
  }

  void draw_robot(const Eigen::Vector2d& point) {
    const cv::Point centre = at(point);
    cv::rectangle(image_, centre - cv::Point{9, 9}, centre + cv::Point{9, 9}, {255, 255, 255}, cv::FILLED);
    cv::rectangle(image_, centre - cv::Point{7, 7}, centre + cv::Point{7, 7}, kRobot, cv::FILLED);
  }

  void draw_person(const Eigen::Vector2d& point) {
    cv::circle(image_, at(point), 10, {255, 255, 255}, cv::FILLED, cv::LINE_AA);
    cv::circle(image_, at(point), 8, kHuman, cv::FILLED, cv::LINE_AA);
  }

  void draw_found(const Eigen::Vector2d& point) {
    cv::drawMarker(image_, at(point), {255, 255, 255}, cv::MARKER_STAR, 30, 6, cv::LINE_AA);
    cv::drawMarker(image_, at(point), kFound, cv::MARKER_STAR, 26, 3, cv::LINE_AA);
  }

  void write(const std::string& text, int line, const cv::Scalar& colour) {
    cv::putText(image_, text, {12, height_px_ + 24 + 24 * line}, cv::FONT_HERSHEY_SIMPLEX, 0.55, colour, 1,
                cv::LINE_AA);
  }

  [[nodiscard]] std::string png() const {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", image_, bytes);
    return {bytes.begin(), bytes.end()};
  }

 private:
  [[nodiscard]] cv::Vec3b colour(CellIndex cell, const std::optional<BeliefView>& belief) const {
    const CellState state = map_.at(cell);
    if (state == CellState::Occupied) return {60, 60, 60};
    if (state == CellState::Unknown) return {200, 200, 200};
    if (belief && belief->resolution_m > 0.0) {
      const Eigen::Vector2d place = (map_.centre_in_map(cell) - belief->origin_in_map) / belief->resolution_m;
      const int column = static_cast<int>(std::floor(place.x()));
      const int row = static_cast<int>(std::floor(place.y()));
      if (column >= 0 && row >= 0 && column < belief->width && row < belief->height) {
        const std::uint8_t value = belief->cells[static_cast<std::size_t>(row * belief->width + column)];
        if (value == 255) return {235, 235, 235};
        // Searched is pale green, likely is violet: the belief that is left.
        const double share = value / 254.0;
        const auto mix = [&](double low, double high) {
          return static_cast<unsigned char>(low + share * (high - low));
        };
        return {mix(225, 235), mix(245, 190), mix(225, 205)};
      }
    }
    return {255, 255, 255};
  }

  const OccupancyGrid& map_;
  double scale_;
  int height_px_;
  cv::Mat image_;
};

}  // namespace

std::string picture_of(const EpisodeView& view) {
  const OccupancyGrid nothing{1, 1, 1.0};
  Picture picture{view.map && !view.map->empty() ? *view.map : nothing};
  picture.draw_ground(view.belief);
  picture.draw_track(view.human_track, kHuman);
  picture.draw_track(view.robot_track, kRobot);
  if (!view.robot_track.empty()) picture.draw_robot(view.robot_track.back());
  if (!view.human_track.empty()) picture.draw_person(view.human_track.back());
  if (view.found_at) picture.draw_found(*view.found_at);
  picture.write(formatted("%s after %.0f s%s%s   explored %.0f %%", view.found_at ? "Found" : "Not found", view.time_s,
                          view.found_by.empty() ? "" : " by ", view.found_by.c_str(), 100.0 * view.explored),
                0, kText);
  picture.write(formatted("robot: %.1f m, %.0f %% seen first", view.robot_distance_m, 100.0 * view.explored_robot), 1,
                kRobot);
  picture.write(
      formatted("%38sperson: %.1f m, %.0f %% seen first", "", view.human_distance_m, 100.0 * view.explored_human), 1,
      kHuman);
  return picture.png();
}

}  // namespace tandem::cli
