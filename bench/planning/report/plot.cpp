#include "bench/planning/report/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "services/common/format.hpp"

namespace tandem::bench {
namespace {

constexpr double kWidth = 640.0;
constexpr double kHeight = 400.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 470.0;  ///< behind it are the names
constexpr double kTop = 40.0;
constexpr double kBottom = 350.0;
constexpr std::array<const char*, 10> kColours{"#0b6e99", "#d9480f", "#2b8a3e", "#862e9c", "#c92a2a",
                                               "#5f3dc4", "#e67700", "#087f5b", "#495057", "#a61e4d"};

/// One axis: from values to places in the picture.
class Axis {
 public:
  Axis(bool logarithmic, double from, double to) : logarithmic_(logarithmic), from_(from), to_(to) {}

  void cover(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  void widen() {
    if (low_ > high_) low_ = 1.0, high_ = 2.0;
    if (low_ == high_) high_ = logarithmic_ ? 2.0 * low_ : low_ + 1.0;
  }
  [[nodiscard]] double place(double value) const {
    const double share =
        logarithmic_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
    return from_ + share * (to_ - from_);
  }
  [[nodiscard]] std::vector<double> ticks() const {
    if (!logarithmic_) return round_ticks(low_, high_, 6);
    std::vector<double> ticks;
    for (double decade = std::pow(10.0, std::floor(std::log10(low_))); decade <= high_; decade *= 10.0) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double value = step * decade;
        if (value >= low_ * 0.999 && value <= high_ * 1.001) ticks.push_back(value);
      }
    }
    return ticks;
  }

 private:
  bool logarithmic_;
  double from_;
  double to_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor) + escaped(text) + "</text>\n";
}

std::string grid_line(double x1, double y1, double x2, double y2) {
  return formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#dddddd\"/>\n", x1, y1, x2, y2);
}

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
  const double raw = (high - low) / count;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * decade;
  for (const double candidate : {1.0, 2.0, 5.0}) {
    if (candidate * decade >= raw * (1.0 - 1e-9)) {
      step = candidate * decade;
      break;
    }
  }
  std::vector<double> ticks;
  for (double index = std::ceil(low / step - 1e-9); index * step <= high + 1e-9 * step; index += 1.0) {
    ticks.push_back(index * step);
  }
  return ticks;
}

std::string plotted(const std::vector<Curve>& curves, const PlotOptions& options) {
  Axis x(options.x_logarithmic, kLeft, kRight);
  Axis y(options.y_logarithmic, kBottom, kTop);
  for (const Curve& curve : curves) {
    for (const auto& [px, py] : curve.points) {
      x.cover(px);
      y.cover(py);
    }
  }
  x.widen();
  y.widen();
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  svg += label(0.5 * (kLeft + kRight), 22.0, "middle", options.title);
  for (const double tick : x.ticks()) {
    svg += grid_line(x.place(tick), kTop, x.place(tick), kBottom);
    svg += label(x.place(tick), kBottom + 16.0, "middle", formatted("%g", tick));
  }
  for (const double tick : y.ticks()) {
    svg += grid_line(kLeft, y.place(tick), kRight, y.place(tick));
    svg += label(kLeft - 6.0, y.place(tick) + 4.0, "end", formatted("%g", tick));
  }
  svg += label(0.5 * (kLeft + kRight), kHeight - 12.0, "middle", options.x_label);
  svg += formatted("<g transform=\"translate(16 %.1f) rotate(-90)\">", 0.5 * (kTop + kBottom)) +
         label(0.0, 0.0, "middle", options.y_label) + "</g>\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const char* colour = kColours[i % kColours.size()];
    svg += "<polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"2\" points=\"";
    for (const auto& [px, py] : curves[i].points) svg += formatted("%.1f,%.1f ", x.place(px), y.place(py));
    svg += "\"/>\n";
    for (const auto& [px, py] : curves[i].points) {
      svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x.place(px), y.place(py), colour);
    }
    svg += "<g fill=\"" + std::string(colour) + "\">" +
           label(kRight + 10.0, kTop + 12.0 + 18.0 * static_cast<double>(i), "start", curves[i].name) + "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace tandem::bench
