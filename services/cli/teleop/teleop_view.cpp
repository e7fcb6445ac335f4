#include "services/cli/teleop/teleop_view.hpp"

#include <cstdio>

namespace tandem::cli {
namespace {

template <typename... Values>
std::string text(const char* format, Values... values) {
  char line[160];
  const int length = std::snprintf(line, sizeof line, format, values...);
  return {line, static_cast<std::size_t>(length)};
}

std::string state_of(const TeleopView::Base& base) {
  if (!base.stopped_by.empty()) {
    std::string reasons;
    for (const auto& reason : base.stopped_by) reasons += (reasons.empty() ? "" : ", ") + reason;
    return "stopped: " + reasons;
  }
  if (base.latched) return "stopped: hold r for a second to resume";
  if (base.resume_in_s > 0.0) return text("stopped: goes on in %.0f s", base.resume_in_s);
  return "free to move";
}

}  // namespace

std::vector<std::string> lines_of(const TeleopView& view) {
  std::vector<std::string> lines{
      "tandem teleop: hold a key to drive, let go to stop",
      "  w ahead   s back   a d turn   q e curve   (or arrows)   space stop   + - speed   r resume   x end",
      "  to record the drive, in another terminal: tandem record -o drive.mcap",
      "",
      text("speed    %.2f m/s, %.2f rad/s when a key is held", view.speeds.forward_mps, view.speeds.turn_rate_radps),
      text("asked    %5.2f m/s  %5.2f rad/s", view.wanted.forward_mps, view.wanted.turn_rate_radps),
      view.measured
          ? text("driven   %5.2f m/s  %5.2f rad/s", view.measured->forward_mps, view.measured->turn_rate_radps)
          : "driven   not known: no odometry comes"};
  if (!view.base) {
    lines.emplace_back("base     its service is silent");
  } else if (!view.base->connected) {
    lines.emplace_back("base     the robot's controller does not answer");
  } else {
    lines.push_back(text("base     %s, motors %s, battery %.1f V, limit %.2f m/s", view.base->model.c_str(),
                         view.base->motors_enabled ? "on" : "off", view.base->battery_v, view.base->speed_limit_mps));
  }
  if (view.base) lines.push_back("gate     " + state_of(*view.base));
  if (!view.resume_answer.empty()) lines.push_back("resume   refused: " + view.resume_answer);
  if (!view.gamepad.empty()) lines.push_back("gamepad  " + view.gamepad);
  return lines;
}

}  // namespace tandem::cli
