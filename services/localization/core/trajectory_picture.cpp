#include "services/localization/core/trajectory_picture.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace tandem {
namespace {

constexpr double kPixelsPerM = 25.0;
constexpr double kMostPixels = 1600.0;  ///< A larger map is drawn smaller.
constexpr double kMarginPx = 20.0;

std::string number(double value) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, 1).ptr;
  return {digits.data(), end};
}

/// From cells to pixels, y downwards.
class Canvas {
 public:
  /// Shows the part of the map in which anything is known.
  explicit Canvas(const OccupancyGrid& map) : map_(map) {
    for (int row = 0; row < map.height(); ++row) {
      for (int column = 0; column < map.width(); ++column) {
        if (map.at(CellIndex{column, row}) == CellState::Unknown) continue;
        first_ = {std::min(first_.column, column), std::min(first_.row, row)};
        last_ = {std::max(last_.column, column + 1), std::max(last_.row, row + 1)};
      }
    }
    if (last_.column == 0) first_ = {0, 0};
    const int longest = std::max({1, last_.column - first_.column, last_.row - first_.row});
    pixels_per_cell_ = std::min(kPixelsPerM * map.resolution_m(), kMostPixels / longest);
  }
  [[nodiscard]] double width() const { return (last_.column - first_.column) * pixels_per_cell_ + 2.0 * kMarginPx; }
  [[nodiscard]] double height() const { return (last_.row - first_.row) * pixels_per_cell_ + 2.0 * kMarginPx; }
  [[nodiscard]] std::string at(const Eigen::Vector2d& in_cells) const {
    return number(kMarginPx + (in_cells.x() - first_.column) * pixels_per_cell_) + " " +
           number(kMarginPx + (last_.row - in_cells.y()) * pixels_per_cell_);
  }
  /// The occupied cells, row by row, as path data.
  [[nodiscard]] std::string walls() const {
    std::string path;
    for (int row = 0; row < map_.height(); ++row) {
      for (int column = 0; column < map_.width(); ++column) {
        if (!map_.is_occupied({column, row})) continue;
        const int start = column;
        while (map_.is_occupied({column + 1, row})) ++column;
        path += "M" + at({static_cast<double>(start), row + 0.5}) + "H" +
                number(kMarginPx + (column + 1 - first_.column) * pixels_per_cell_);
      }
    }
    return path;
  }
  [[nodiscard]] std::string way(std::span<const TimedPose> poses) const {
    std::string points;
    for (const TimedPose& pose : poses) points += at(map_.in_cells(pose.map_from_base.position())) + " ";
    return points;
  }
  [[nodiscard]] std::string links(std::span<const PictureLink> closures) const {
    std::string path;
    for (const PictureLink& link : closures) {
      path += "M" + at(map_.in_cells(link.from_in_map)) + "L" + at(map_.in_cells(link.to_in_map));
    }
    return path;
  }
  [[nodiscard]] double cell_px() const { return pixels_per_cell_; }

 private:
  const OccupancyGrid& map_;
  double pixels_per_cell_ = 1.0;
  CellIndex first_{1 << 30, 1 << 30};
  CellIndex last_{0, 0};
};

}  // namespace

std::string trajectory_picture(const OccupancyGrid& map, std::span<const TimedPose> estimate,
                               const PictureLayers& layers) {
  const Canvas canvas{map};
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(canvas.width()) + "\" height=\"" +
                    number(canvas.height()) + "\" font-family=\"sans-serif\" font-size=\"13\">\n" +
                    "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  svg += "<path d=\"" + canvas.walls() + "\" stroke=\"#222\" stroke-width=\"" + number(canvas.cell_px()) + "\"/>\n";
  if (!layers.truth.empty()) {
    svg += "<polyline points=\"" + canvas.way(layers.truth) +
           "\" fill=\"none\" stroke=\"#f28e2b\" stroke-linejoin=\"round\" stroke-width=\"5\"/>\n";
    svg += "<text x=\"150\" y=\"15\" fill=\"#f28e2b\">true</text>\n";
  }
  svg += "<polyline points=\"" + canvas.way(estimate) + "\" fill=\"none\" stroke=\"#1f77b4\" stroke-width=\"1.5\"/>\n";
  svg += "<text x=\"20\" y=\"15\" fill=\"#1f77b4\">estimated</text>\n";
  if (!layers.closures.empty()) {
    svg += "<path d=\"" + canvas.links(layers.closures) +
           "\" stroke=\"#d62728\" stroke-linecap=\"round\" stroke-width=\"4\"/>\n";
    svg += "<text x=\"210\" y=\"15\" fill=\"#d62728\">closures</text>\n";
  }
  svg += "</svg>\n";
  return svg;
}

}  // namespace tandem
