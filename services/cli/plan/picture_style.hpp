#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <string>

#include "services/cli/plan/plan_picture.hpp"
#include "services/cli/plan/svg.hpp"

namespace tandem::cli {

/// Where a panel lies on the picture [px].
struct PanelBox {
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

// Colours that the colour-blind tell apart (Okabe and Ito); nothing is said by colour alone.

[[nodiscard]] inline std::string colour_of(SourceKind kind) {
  switch (kind) {
    case SourceKind::Environment:
      return "#009e73";
    case SourceKind::Action:
      return "#b8860b";
    case SourceKind::Interaction:
      return "#b0508f";
    case SourceKind::Task:
      break;
  }
  return "#0072b2";
}

[[nodiscard]] inline bool repels(const RewardSource& source) {
  const double inside = peak_of(source.inside);
  return inside < 0.0 || (inside == 0.0 && peak_of(source.outside) < 0.0);
}

/// The fill of a source: hatched if it repels.
[[nodiscard]] inline std::string fill_of(const RewardSource& source) {
  const std::string colour = colour_of(source.kind);
  return repels(source) ? "fill=\"url(#hatch" + colour.substr(1) + ")\""
                        : "fill=\"" + colour + "\" fill-opacity=\"0.25\"";
}

[[nodiscard]] inline std::string colour_of_agent(std::size_t agent) {
  constexpr std::array<const char*, 8> kColours{"#d55e00", "#222222", "#3a7fd5", "#7a5c00",
                                                "#882255", "#117733", "#332288", "#aa4499"};
  return kColours[agent % kColours.size()];
}

[[nodiscard]] inline std::string dashes_of_agent(std::size_t agent) {
  constexpr std::array<const char*, 4> kDashes{"", "9 4", "3 3", "12 3 3 3"};
  const std::string dashes = kDashes[agent % kDashes.size()];
  return dashes.empty() ? "" : " stroke-dasharray=\"" + dashes + "\"";
}

/// The sign of an agent: a square, a person's circle, a drone's triangle.
inline void draw_agent_sign(Svg& svg, const Eigen::Vector2d& at, ScenarioAgentKind kind, std::size_t agent) {
  const std::string style = "fill=\"" + colour_of_agent(agent) + "\" stroke=\"#fff\" stroke-width=\"1.5\"";
  switch (kind) {
    case ScenarioAgentKind::Robot:
      return svg.rectangle(at.x() - 6.0, at.y() - 6.0, 12.0, 12.0, style);
    case ScenarioAgentKind::Person:
      return svg.circle(at, 6.5, style);
    case ScenarioAgentKind::Drone:
      return svg.polygon({{at.x(), at.y() - 8.0}, {at.x() + 7.5, at.y() + 5.5}, {at.x() - 7.5, at.y() + 5.5}}, style);
  }
}

/// A round step of an axis that is `length` long, so that it has at most `most` of them.
[[nodiscard]] inline double round_step(double length, int most) {
  constexpr std::array<double, 12> kSteps{1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0};
  for (const double step : kSteps) {
    if (length <= step * most) return step;
  }
  return std::ceil(length / most / 3600.0) * 3600.0;
}

/// About how wide a text is [px].
[[nodiscard]] inline double width_of_text(const std::string& words, double font_size) {
  return 0.56 * font_size * static_cast<double>(words.size());
}

/// Text that stays legible on whatever lies below it.
inline constexpr const char* kHalo =
    "paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\" stroke-linejoin=\"round\"";

}  // namespace tandem::cli
