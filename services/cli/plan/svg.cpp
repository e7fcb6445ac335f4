#include "services/cli/plan/svg.hpp"

#include <map>
#include <utility>

#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

using Eigen::Vector2d;

std::string points_of(const std::vector<Vector2d>& points) {
  std::string text;
  for (const Vector2d& point : points) {
    text += (text.empty() ? "" : " ") + svg_number(point.x()) + "," + svg_number(point.y());
  }
  return text;
}

std::string attribute(std::string_view name, double value) {
  return " " + std::string{name} + "=\"" + svg_number(value) + "\"";
}

std::string with(std::string_view style) {
  return style.empty() ? "" : " " + std::string{style};
}

}  // namespace

Svg::Svg(double width, double height)
    : size_(attribute("width", width) + attribute("height", height) + " viewBox=\"0 0 " + svg_number(width) + " " +
            svg_number(height) + "\"") {}

void Svg::define(std::string_view definition) {
  definitions_ += std::string{definition} + "\n";
}

void Svg::begin_group(std::string_view style) {
  body_ += "<g" + with(style) + ">\n";
}

void Svg::end_group() {
  body_ += "</g>\n";
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view style) {
  body_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) + attribute("height", height) +
           with(style) + "/>\n";
}

void Svg::circle(const Vector2d& centre, double radius, std::string_view style) {
  body_ += "<circle" + attribute("cx", centre.x()) + attribute("cy", centre.y()) + attribute("r", radius) +
           with(style) + "/>\n";
}

void Svg::line(const Vector2d& from, const Vector2d& to, std::string_view style) {
  body_ += "<line" + attribute("x1", from.x()) + attribute("y1", from.y()) + attribute("x2", to.x()) +
           attribute("y2", to.y()) + with(style) + "/>\n";
}

void Svg::polyline(const std::vector<Vector2d>& points, std::string_view style) {
  body_ += "<polyline points=\"" + points_of(points) + "\"" + with(style) + "/>\n";
}

void Svg::polygon(const std::vector<Vector2d>& points, std::string_view style) {
  body_ += "<polygon points=\"" + points_of(points) + "\"" + with(style) + "/>\n";
}

void Svg::path(std::string_view data, std::string_view style) {
  body_ += "<path d=\"" + std::string{data} + "\"" + with(style) + "/>\n";
}

void Svg::text(const Vector2d& at, std::string_view words, std::string_view style) {
  body_ +=
      "<text" + attribute("x", at.x()) + attribute("y", at.y()) + with(style) + ">" + svg_escaped(words) + "</text>\n";
}

std::string Svg::file() const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + size_ +
         " font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n<defs>\n" + definitions_ + "</defs>\n" +
         body_ + "</svg>\n";
}

std::string svg_number(double value) {
  std::string text = formatted("%.2f", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svg_escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return text;
}

std::string svg_cells(int width, int height, const std::function<bool(int, int)>& is_set) {
  std::string data;
  std::map<std::pair<int, int>, int> open;  // runs (first column, length) and the row in which they began
  const auto close = [&](const std::pair<int, int>& run, int from_row, int to_row) {
    const std::string length = std::to_string(run.second);
    data += "M" + std::to_string(run.first) + " " + std::to_string(from_row) + "h" + length + "v" +
            std::to_string(to_row - from_row) + "h-" + length + "z";
  };
  for (int row = 0; row <= height; ++row) {
    std::map<std::pair<int, int>, int> runs;
    for (int column = 0; row < height && column < width; ++column) {
      const int first = column;
      while (column < width && is_set(column, row)) ++column;
      if (column == first) continue;
      const std::pair<int, int> run{first, column - first};
      const auto above = open.find(run);
      runs.emplace(run, above != open.end() ? above->second : row);
    }
    for (const auto& [run, from_row] : open) {
      if (!runs.contains(run)) close(run, from_row, row);
    }
    open = std::move(runs);
  }
  return data;
}

}  // namespace tandem::cli
