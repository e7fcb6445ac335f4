#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tandem::cli {

/// Points of one colour.
struct PlotSeries {
  std::string name;
  std::string colour;
  std::vector<Eigen::Vector2d> points;
};

struct PlotLabels {
  std::string title;
  std::string x_label;
};

/// Points above and below zero, as an SVG element. The scale shows 98 % of all points; those beyond lie on the rim.
[[nodiscard]] std::string scatter_plot(const PlotLabels& labels, const std::vector<PlotSeries>& series);

}  // namespace tandem::cli
