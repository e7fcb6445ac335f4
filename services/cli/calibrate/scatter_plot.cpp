#include "services/cli/calibrate/scatter_plot.hpp"

#include <algorithm>
#include <cmath>

#include "services/cli/plan/svg.hpp"

namespace tandem::cli {
namespace {

constexpr double kWidth = 820.0;
constexpr double kHeight = 240.0;
constexpr double kLeft = 60.0;
constexpr double kTop = 34.0;
constexpr double kBottom = 36.0;
constexpr double kShownShare = 0.98;

/// 1, 2 or 5 times a power of ten, at least `value`.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value) return step * power;
  }
  return 10.0 * power;
}

struct Scale {
  double x_max = 1.0;
  double y_max = 1.0;

  [[nodiscard]] Eigen::Vector2d at(double x, double y) const {
    const double half = (kHeight - kTop - kBottom) / 2.0;
    return {kLeft + (kWidth - kLeft - 10.0) * x / x_max, kTop + half * (1.0 - std::clamp(y / y_max, -1.0, 1.0))};
  }
};

Scale scale_of(const std::vector<PlotSeries>& series) {
  Scale scale;
  std::vector<double> sizes;
  for (const PlotSeries& one : series) {
    for (const Eigen::Vector2d& point : one.points) {
      scale.x_max = std::max(scale.x_max, point.x());
      sizes.push_back(std::abs(point.y()));
    }
  }
  if (sizes.empty()) return scale;
  std::sort(sizes.begin(), sizes.end());
  scale.y_max = round_up(sizes[static_cast<std::size_t>(kShownShare * static_cast<double>(sizes.size() - 1))]);
  return scale;
}

void draw_axes(Svg& svg, const Scale& scale, const std::string& x_label) {
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double y = share * scale.y_max;
    svg.line(scale.at(0.0, y), scale.at(scale.x_max, y), share == 0.0 ? R"(stroke="#888")" : R"(stroke="#ddd")");
    svg.text(scale.at(0.0, y) + Eigen::Vector2d{-8.0, 4.0}, svg_number(y), R"(text-anchor="end" fill="#555")");
  }
  const double step = round_up(scale.x_max / 6.0);
  for (double x = 0.0; x <= scale.x_max; x += step) {
    svg.text(scale.at(x, -scale.y_max) + Eigen::Vector2d{0.0, 16.0}, svg_number(x),
             R"(text-anchor="middle" fill="#555")");
  }
  svg.text({kWidth - 10.0, kHeight - 4.0}, x_label, R"(text-anchor="end" fill="#555")");
}

}  // namespace

std::string scatter_plot(const PlotLabels& labels, const std::vector<PlotSeries>& series) {
  const Scale scale = scale_of(series);
  Svg svg{kWidth, kHeight};
  svg.begin_group(R"(font-family="sans-serif" font-size="12")");
  svg.text({kLeft, 16.0}, labels.title, R"(font-size="14" font-weight="bold")");
  double legend = kWidth - 10.0;
  for (const PlotSeries& one : series) {
    svg.text({legend, 16.0}, one.name, "text-anchor=\"end\" fill=\"" + one.colour + "\"");
    legend -= 90.0;
  }
  draw_axes(svg, scale, labels.x_label);
  for (const PlotSeries& one : series) {
    svg.begin_group("fill=\"" + one.colour + "\" fill-opacity=\"0.7\"");
    for (const Eigen::Vector2d& point : one.points) svg.circle(scale.at(point.x(), point.y()), 2.0, "");
    svg.end_group();
  }
  svg.end_group();
  return svg.file();
}

}  // namespace tandem::cli
