#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tandem::bench {

/// A line of a plot: points (x, y) in order, and their name.
struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct PlotOptions {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool x_logarithmic = false;
  bool y_logarithmic = false;
};

/// The curves as an SVG picture, each in a colour of its own with its name beside it. Logarithmic axes need values > 0.
[[nodiscard]] std::string plotted(const std::vector<Curve>& curves, const PlotOptions& options);

/// Round values that divide [low, high] into about `count` parts: 1, 2 or 5 times a power of ten.
[[nodiscard]] std::vector<double> round_ticks(double low, double high, int count);

}  // namespace tandem::bench
