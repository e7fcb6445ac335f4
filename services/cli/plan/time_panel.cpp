#include "services/cli/plan/time_panel.hpp"

#include <algorithm>

namespace tandem::cli {
namespace {

using Eigen::Vector2d;

constexpr double kHead = 24.0;
constexpr double kAgentRow = 24.0;
constexpr double kPoolRow = 34.0;
constexpr double kFoundRow = 110.0;
constexpr double kAxis = 32.0;
constexpr double kNames = 130.0;  ///< left of the rows
constexpr double kRight = 40.0;   ///< right of them

/// One row: names to the left, time to the right.
struct Row {
  double left = 0.0;
  double width = 0.0;
  double top = 0.0;
  double end_s = 1.0;
  [[nodiscard]] double x(double time_s) const { return left + width * std::clamp(time_s / end_s, 0.0, 1.0); }
};

bool has_pool(const PlanPicture& picture, std::size_t source) {
  return source < picture.drains.size() && !picture.drains[source].empty();
}

void draw_name(Svg& svg, const Row& row, double below, const std::string& name, const std::string& colour) {
  svg.text({row.left - 8.0, row.top + below}, name, "text-anchor=\"end\" fill=\"" + colour + "\"");
}

void draw_agent_row(Svg& svg, const Row& row, const PlanPicture& picture, std::size_t index) {
  const PicturedAgent& agent = picture.agents[index];
  const std::string colour = colour_of_agent(index);
  draw_name(svg, row, 15.0, agent.id, colour);
  const double middle = row.top + 11.0;
  svg.line({row.left, middle}, {row.left + row.width, middle}, "stroke=\"#ccc\"");
  for (std::size_t i = 0; i + 1 < agent.path.points.size(); ++i) {
    const TimedPoint& from = agent.path.points[i];
    const TimedPoint& to = agent.path.points[i + 1];
    if (from.point_in_map == to.point_in_map) continue;
    svg.line({row.x(from.time_s), middle}, {row.x(to.time_s), middle},
             "stroke=\"" + colour + "\" stroke-width=\"2.2\"" + dashes_of_agent(index));
  }
  double free_from = row.left;
  for (const TaskVisit& visit : agent.visits) {
    const RewardSource& source = picture.world.sources[visit.source];
    const double x = row.x(visit.arrive_s);
    const double width = std::max(3.0, row.x(visit.leave_s) - x);
    svg.rectangle(x, row.top + 4.0, width, 14.0,
                  "fill=\"" + colour_of(source.kind) + "\" fill-opacity=\"0.6\" stroke=\"" + colour + "\"");
    const double needed = width_of_text(source.id, 10.0);
    const bool inside = needed + 6.0 < width;
    const double at = inside ? x + 3.0 : x + width + 3.0;
    if (at < free_from) continue;
    const bool turned = at + needed > row.left + row.width + kRight;
    svg.text({turned ? x - 3.0 : at, row.top + 15.0}, source.id,
             std::string{"font-size=\"10\" "} + (turned ? "text-anchor=\"end\" " : "") + kHalo);
    free_from = at + needed;
  }
}

void draw_pool_row(Svg& svg, const Row& row, const PlanPicture& picture, std::size_t index) {
  const RewardSource& source = picture.world.sources[index];
  const auto& drain = picture.drains[index];
  const std::string colour = colour_of(source.kind);
  draw_name(svg, row, 20.0, source.id, colour);
  const double bottom = row.top + kPoolRow - 6.0;
  const double height = kPoolRow - 12.0;
  double most = 0.0;
  for (const DrainPoint& point : drain) most = std::max(most, std::abs(point.left));
  std::vector<Vector2d> outline{{row.left, bottom}};
  const auto add = [&](double time_s, double left) {
    outline.emplace_back(row.x(time_s), bottom - (most > 0.0 ? height * std::abs(left) / most : 0.0));
  };
  for (const DrainPoint& point : drain) add(point.time_s, point.left);
  add(picture.end_s, drain.back().left);
  outline.emplace_back(row.left + row.width, bottom);
  svg.polygon(outline, fill_of(source) + " stroke=\"" + colour + "\"");
  svg.text({row.left + row.width + 5.0, row.top + 20.0}, svg_number(drain.back().left), "font-size=\"10\"");
}

void draw_found_row(Svg& svg, const Row& row, const PlanPicture& picture) {
  draw_name(svg, row, 20.0, "found", "#0072b2");
  const double bottom = row.top + kFoundRow - 8.0;
  const double height = kFoundRow - 16.0;
  std::vector<Vector2d> outline{{row.left, bottom}};
  for (std::size_t i = 0; i < picture.found.size(); ++i) {
    const double time_s = static_cast<double>(i) * picture.found_step_s;
    if (time_s > picture.end_s + 1e-9) break;
    outline.emplace_back(row.x(time_s), bottom - height * picture.found[i]);
  }
  outline.emplace_back(outline.back().x(), bottom);
  svg.polygon(outline, "fill=\"#0072b2\" fill-opacity=\"0.25\" stroke=\"#0072b2\"");
  for (const double share : {0.5, 1.0}) {
    const double y = bottom - height * share;
    svg.line({row.left, y}, {row.left + row.width, y}, "stroke=\"#999\" stroke-dasharray=\"2 3\"");
    svg.text({row.left + row.width + 5.0, y + 4.0}, svg_number(100.0 * share) + " %", "font-size=\"10\"");
  }
}

void draw_axis(Svg& svg, const Row& row, double top, double bottom) {
  const double step_s = round_step(row.end_s, 12);
  for (double time_s = 0.0; time_s <= row.end_s + 1e-9; time_s += step_s) {
    svg.line({row.x(time_s), top}, {row.x(time_s), bottom}, "stroke=\"#ddd\"");
    svg.text({row.x(time_s), bottom + 14.0}, svg_number(time_s), "text-anchor=\"middle\" font-size=\"10\"");
  }
  svg.line({row.left, bottom}, {row.left + row.width, bottom}, "stroke=\"#333\"");
  svg.text({row.left + row.width + 16.0, bottom + 14.0}, "s", "font-size=\"10\"");
}

}  // namespace

double height_of_times(const PlanPicture& picture) {
  double height = kHead + kAgentRow * static_cast<double>(picture.agents.size()) + kAxis;
  for (std::size_t i = 0; i < picture.world.sources.size(); ++i) height += has_pool(picture, i) ? kPoolRow : 0.0;
  return height + (picture.found.empty() ? 0.0 : kFoundRow);
}

void draw_times(Svg& svg, const PanelBox& box, const PlanPicture& picture) {
  svg.text({box.x, box.y + 12.0},
           picture.found.empty() ? "Who is where, and what is left in the pools" : "Who walks, and what is found",
           "font-weight=\"bold\"");
  Row row{box.x + kNames, box.width - kNames - kRight, box.y + kHead, picture.end_s};
  draw_axis(svg, row, row.top, box.y + height_of_times(picture) - kAxis);
  for (std::size_t i = 0; i < picture.agents.size(); ++i) {
    draw_agent_row(svg, row, picture, i);
    row.top += kAgentRow;
  }
  for (std::size_t i = 0; i < picture.world.sources.size(); ++i) {
    if (!has_pool(picture, i)) continue;
    draw_pool_row(svg, row, picture, i);
    row.top += kPoolRow;
  }
  if (!picture.found.empty()) draw_found_row(svg, row, picture);
}

}  // namespace tandem::cli
