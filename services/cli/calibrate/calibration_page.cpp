#include "services/cli/calibrate/calibration_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "services/cli/calibrate/page.hpp"
#include "services/cli/calibrate/scatter_plot.hpp"

namespace tandem::cli {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

std::string knowledge_table(const std::vector<ParameterKnowledge>& known) {
  std::string rows = table_row({"", "value", "standard deviation", "at most"}, "th");
  for (const ParameterKnowledge& one : known) {
    const std::string unit = one.unit.empty() ? "" : " " + one.unit;
    if (one.held) {
      rows += table_row({one.name, "held: " + page_number(one.value, 4), "", ""}, "td");
    } else {
      rows += table_row({one.name, page_number(one.value, 4) + unit, page_number(one.deviation, 4) + unit,
                         page_number(one.limit, 3) + unit + (one.is_known() ? " \u2713" : " \u2717")},
                        "td");
    }
  }
  return "<table>\n" + rows + "</table>\n";
}

std::string motion_table(const DrivenMotion& motion) {
  return "<table>\n" + table_row({"pairs of scans", std::to_string(motion.pairs)}, "td") +
         table_row({"driven straight", page_number(motion.straight_m, 1) + " m"}, "td") +
         table_row({"turned to the left", page_number(motion.left_rad / kTurn, 2) + " turns"}, "td") +
         table_row({"turned to the right", page_number(motion.right_rad / kTurn, 2) + " turns"}, "td") + "</table>\n";
}

std::string residual_plot(const std::vector<PairResidual>& residuals, int axis, double factor, const char* title) {
  std::vector<Eigen::Vector2d> before;
  std::vector<Eigen::Vector2d> after;
  for (const PairResidual& one : residuals) {
    const double seconds = to_seconds(one.from - residuals.front().from);
    before.push_back({seconds, factor * one.before(axis)});
    after.push_back({seconds, factor * one.after(axis)});
  }
  return scatter_plot({.title = title, .x_label = "time [s]"},
                      {{"before", "#c9a27a", before}, {"calibrated", "#1f5fa8", after}});
}

std::string noise_table(const MotionNoise& noise) {
  return "<table>\n" + table_row({"forward_per_m", page_number(noise.forward_per_m, 3)}, "td") +
         table_row({"sideways_per_m", page_number(noise.sideways_per_m, 3)}, "td") +
         table_row({"turn_per_rad", page_number(noise.turn_per_rad, 3)}, "td") +
         table_row({"turn_per_m", page_number(noise.turn_per_m, 3)}, "td") + "</table>\n";
}

std::size_t doubted(const std::vector<PairResidual>& residuals) {
  return static_cast<std::size_t>(
      std::count_if(residuals.begin(), residuals.end(), [](const auto& one) { return one.weight < 0.3; }));
}

}  // namespace

std::string calibration_page(const WheelCalibrationResult& result) {
  std::string body = "<h1>Calibration of wheels and laser</h1>\n<p>" + escaped_html(result.recording) + ", robot " +
                     escaped_html(result.model) +
                     (result.model_is_known ? "" : " (taken for one: nobody named the model)") + "</p>\n";
  if (!result.missing.empty()) {
    body += "<div class=\"bad\"><b>This recording does not calibrate the robot.</b> Record another, and:<ul>\n";
    for (const std::string& missing : result.missing) body += "<li>" + escaped_html(missing) + "</li>\n";
    body += "</ul></div>\n";
  } else {
    body +=
        "<div class=\"good\"><b>Everything was found.</b> Copy the TOML files beside this page to the robot.</div>\n";
  }
  if (!result.known.empty()) {
    body += "<h2>What was found</h2>\n" + knowledge_table(result.known) +
            "<p>Wheels and track are shares of what the robot's controller counts with. They come from the odometry's "
            "poses: a recording holds no counts of the wheels. The laser's clock is what to add to its stamps.</p>\n";
  }
  body += "<h2>What the robot drove</h2>\n" + motion_table(result.motion);
  const auto& residuals = result.calibration.residuals;
  if (!residuals.empty()) {
    body +=
        "<h2>Wheels against scans</h2>\n<p>Each point is the way from one scan to another, about 0.4 m or 0.4 rad: "
        "what the wheels say minus what the scans say. Calibrated points lie around zero without a trend. " +
        std::to_string(doubted(residuals)) + " of " + std::to_string(residuals.size()) +
        " pairs were doubted and hardly counted: there the wheels slipped, or the scans did not fit.</p>\n" +
        residual_plot(residuals, 0, 1e3, "ahead [mm]") + residual_plot(residuals, 1, 1e3, "to the left [mm]") +
        residual_plot(residuals, 2, to_degrees(1.0), "turn [degrees]");
    if (!result.hold_wheels) {
      body +=
          "<h2>Noise of the wheels</h2>\n<p>For localization.toml: twice what the points above show, as other floors "
          "are worse.</p>\n" +
          noise_table(result.noise);
    }
  }
  return html_page("Calibration", body);
}

}  // namespace tandem::cli
