#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tandem::cli {

/// A drawing as SVG text, element by element, in pixels; y points down. Equal drawings are equal bytes: numbers have at
/// most two decimals.
///
/// `style` everywhere: attributes as they stand in the text, such as `fill="none" stroke="#000"`.
class Svg {
 public:
  Svg(double width, double height);

  /// Text among the definitions: patterns, markers, clip paths.
  void define(std::string_view definition);
  void begin_group(std::string_view style);
  void end_group();
  void rectangle(double x, double y, double width, double height, std::string_view style);
  void circle(const Eigen::Vector2d& centre, double radius, std::string_view style);
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view style);
  void polyline(const std::vector<Eigen::Vector2d>& points, std::string_view style);
  void polygon(const std::vector<Eigen::Vector2d>& points, std::string_view style);
  /// `data` as in the d attribute.
  void path(std::string_view data, std::string_view style);
  /// `words` may hold any characters.
  void text(const Eigen::Vector2d& at, std::string_view words, std::string_view style);

  /// The whole file.
  [[nodiscard]] std::string file() const;

 private:
  std::string size_;
  std::string definitions_;
  std::string body_;
};

/// A number with at most two decimals.
[[nodiscard]] std::string svg_number(double value);

/// Text with the characters replaced that mean something in XML.
[[nodiscard]] std::string svg_escaped(std::string_view words);

/// The cells of a grid for which `is_set` holds, as path data of few rectangles in units of cells.
[[nodiscard]] std::string svg_cells(int width, int height, const std::function<bool(int column, int row)>& is_set);

}  // namespace tandem::cli
