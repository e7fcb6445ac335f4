#include "services/cli/plan/place_panel.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "services/cli/plan/labels.hpp"
#include "services/common/format.hpp"
#include "services/planner/core/srs/resolved_boundary.hpp"

namespace tandem::cli {
namespace {

using Eigen::Vector2d;

constexpr double kLeastRadius = 5.0;  ///< of a source that is drawn [px]
constexpr double kFar_m = 2000.0;     ///< as far as a half-plane is drawn
constexpr int kMostDots = 12;         ///< on the longest path
constexpr int kBeliefLevels = 8;

struct Bounds {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = Vector2d::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vector2d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

/// What of the map is known, and where anybody goes.
Bounds bounds_of(const PlanPicture& picture) {
  Bounds bounds;
  for (const OccupancyGrid& layer : picture.layers) {
    for (int row = 0; row < layer.height(); ++row) {
      for (int column = 0; column < layer.width(); ++column) {
        if (layer.at(CellIndex{column, row}) != CellState::Unknown) bounds.add(layer.centre_in_map({column, row}));
      }
    }
  }
  for (const PicturedAgent& agent : picture.agents) {
    bounds.add(agent.start.position());
    for (const TimedPoint& point : agent.path.points) bounds.add(point.point_in_map);
  }
  const double margin_m = picture.layers.empty() ? 1.0 : 0.5 * picture.layers.front().resolution_m();
  bounds.low.array() -= margin_m;
  bounds.high.array() += margin_m;
  return bounds;
}

/// From the map to the picture.
class View {
 public:
  View(const Bounds& bounds, const PanelBox& box)
      : scale_(
            std::min(box.width / (bounds.high.x() - bounds.low.x()), box.height / (bounds.high.y() - bounds.low.y()))),
        low_(bounds.low),
        corner_(box.x, box.y + box.height) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Vector2d operator()(const Vector2d& point_in_map) const {
    const Vector2d off = scale_ * (point_in_map - low_);
    return {corner_.x() + off.x(), corner_.y() - off.y()};
  }
  [[nodiscard]] std::vector<Vector2d> operator()(const std::vector<Vector2d>& points_in_map) const {
    std::vector<Vector2d> points;
    for (const Vector2d& point : points_in_map) points.push_back((*this)(point));
    return points;
  }
  /// The transform from the cells of a grid, columns and rows, to the picture.
  [[nodiscard]] std::string from_cells(const Pose2& map_from_grid, double cell_m) const {
    // Of the columns' direction two decimals are not enough.
    const double c = scale_ * cell_m * std::cos(map_from_grid.heading);
    const double s = scale_ * cell_m * std::sin(map_from_grid.heading);
    const Vector2d origin = (*this)(map_from_grid.position());
    std::string text = "transform=\"matrix(";
    for (const double value : {c, -s, -s, -c}) text += precise(value) + " ";
    return text + svg_number(origin.x()) + " " + svg_number(origin.y()) + ")\" shape-rendering=\"crispEdges\"";
  }

 private:
  static std::string precise(double value) { return formatted("%.6f", value == 0.0 ? 0.0 : value); }

  double scale_;
  Vector2d low_;
  Vector2d corner_;
};

void draw_belief(Svg& svg, const View& view, const PicturedBelief& belief) {
  const double peak = belief.density.empty() ? 0.0 : *std::ranges::max_element(belief.density);
  if (peak <= 0.0) return;
  const Pose2 corner{belief.origin_in_map.x(), belief.origin_in_map.y(), 0.0};
  svg.begin_group(view.from_cells(corner, belief.cell_size_m) + " fill=\"#0072b2\"");
  const auto level_of = [&](int column, int row) {
    const auto cell =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(belief.width) + static_cast<std::size_t>(column);
    return static_cast<int>(std::ceil(kBeliefLevels * belief.density[cell] / peak - 1e-6));
  };
  for (int level = 1; level <= kBeliefLevels; ++level) {
    const std::string cells =
        svg_cells(belief.width, belief.height, [&](int column, int row) { return level_of(column, row) == level; });
    if (!cells.empty()) svg.path(cells, "fill-opacity=\"" + svg_number(0.05 * level) + "\"");
  }
  svg.end_group();
}

void draw_walls(Svg& svg, const View& view, const std::vector<OccupancyGrid>& layers) {
  if (layers.empty()) return;
  const OccupancyGrid& floor = layers.front();
  svg.begin_group(view.from_cells(floor.map_from_grid(), floor.resolution_m()));
  const auto is_low = [&](int column, int row) {
    return std::ranges::any_of(layers, [&](const OccupancyGrid& layer) { return !layer.is_occupied({column, row}); });
  };
  const auto draw = [&](const auto& is_set, const char* style) {
    const std::string cells = svg_cells(floor.width(), floor.height(), is_set);
    if (!cells.empty()) svg.path(cells, style);
  };
  draw([&](int c, int r) { return floor.at(CellIndex{c, r}) == CellState::Unknown; }, "fill=\"#e4e4e4\"");
  draw([&](int c, int r) { return floor.is_occupied({c, r}) && !is_low(c, r); }, "fill=\"#555\"");
  draw([&](int c, int r) { return floor.is_occupied({c, r}) && is_low(c, r); }, "fill=\"#aaa\"");
  svg.end_group();
}

/// Where the name of a shape stands: around this point [px].
struct NamePlace {
  Vector2d at = Vector2d::Zero();
  double off = 0.0;
};

/// Draws the shape.
NamePlace draw_shape(Svg& svg, const View& view, const PlanarShape& shape, const std::string& fill,
                     const std::string& line) {
  if (const auto* disc = std::get_if<Disc>(&shape)) {
    const Vector2d centre = view(disc->centre);
    const double radius = std::max(kLeastRadius, view.scale() * disc->radius_m);
    svg.circle(centre, radius, fill + line);
    return {centre, radius + 3.0};
  }
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    svg.polygon(view(polygon->corners), fill + line);
    return {view(inner_point(shape)), 2.0};
  }
  if (const auto* corridor = std::get_if<Corridor>(&shape)) {
    const double width = std::max(2.0, 2.0 * view.scale() * corridor->half_width_m);
    std::string stroke = fill;
    for (std::size_t at = 0; (at = stroke.find("fill", at)) != std::string::npos;) stroke.replace(at, 4, "stroke");
    svg.polyline(view(corridor->points), "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" " + stroke +
                                             " stroke-width=\"" + svg_number(width) + "\"");
    return {view(inner_point(shape)), 2.0};
  }
  const auto& plane = std::get<HalfPlane>(shape);
  const Vector2d out = plane.outward.normalized();
  const Vector2d along{-out.y(), out.x()};
  svg.polygon(view({plane.point + kFar_m * along, plane.point - kFar_m * along, plane.point - kFar_m * (along + out),
                    plane.point + kFar_m * (along - out)}),
              fill + line);
  return {view(inner_point(shape)), 2.0};
}

/// The shape of a boundary on the map when the agents are where they are at `time_s`.
std::optional<PlanarShape> shape_when(const Boundary& boundary, const PlanPicture& picture, double time_s) {
  if (const auto* sphere = std::get_if<Sphere>(&boundary)) {
    return Disc{sphere->centre_in_map.head<2>(), sphere->radius_m};
  }
  if (const auto* box = std::get_if<Box>(&boundary)) {
    const auto& low = box->low_in_map;
    const auto& high = box->high_in_map;
    return Polygon{{{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}}};
  }
  std::vector<AgentMove> moves;
  for (const PicturedAgent& agent : picture.agents) {
    const Pose2 pose = time_s > 0.0 && !agent.path.points.empty() ? pose_at(agent.path, time_s) : agent.start;
    moves.push_back(stay_at(pose.position(), pose.heading));
  }
  if (moves.size() != picture.world.agents.size()) return std::nullopt;
  return shape_at(resolved(boundary, picture.world.agents), {moves, 1.0}, 0.0);
}

void draw_sources(Svg& svg, const View& view, const PlanPicture& picture, Labels& labels) {
  std::vector<std::pair<NamePlace, const RewardSource*>> names;
  for (const RewardSource& source : picture.world.sources) {
    const std::string line = " stroke=\"" + colour_of(source.kind) + "\"";
    const bool moves = !owners_of(source.boundary).empty();
    if (moves) {
      if (const auto later = shape_when(source.boundary, picture, picture.end_s)) {
        draw_shape(svg, view, *later, "fill=\"none\"", line + " stroke-dasharray=\"2 4\"");
      }
    }
    if (const auto shape = shape_when(source.boundary, picture, 0.0)) {
      names.emplace_back(
          draw_shape(svg, view, *shape, fill_of(source), line + (moves ? " stroke-dasharray=\"6 3\"" : "")), &source);
    }
  }
  for (const auto& [place, source] : names) {
    labels.add(svg, place.at, place.off, source->id, 12.0, "fill=\"" + colour_of(source->kind) + "\"");
  }
}

void draw_path(Svg& svg, const View& view, const PicturedAgent& agent, std::size_t index) {
  std::vector<Vector2d> points{agent.start.position()};
  for (const TimedPoint& point : agent.path.points) points.push_back(point.point_in_map);
  svg.polyline(view(points), "fill=\"none\" stroke=\"" + colour_of_agent(index) +
                                 "\" stroke-width=\"2.2\" stroke-linejoin=\"round\"" + dashes_of_agent(index));
}

void draw_start(Svg& svg, const View& view, const PicturedAgent& agent, std::size_t index, Labels& labels) {
  const std::string colour = colour_of_agent(index);
  const Vector2d start = view(agent.start.position());
  const Vector2d ahead{std::cos(agent.start.heading), -std::sin(agent.start.heading)};
  svg.line(start, start + 13.0 * ahead, "stroke=\"" + colour + "\" stroke-width=\"2.5\"");
  draw_agent_sign(svg, start, agent.kind, index);
  labels.add(svg, start, 9.0, agent.id, 12.0, "font-weight=\"bold\" fill=\"" + colour + "\"");
}

void draw_dots(Svg& svg, const View& view, const PicturedAgent& agent, std::size_t index, double step_s,
               Labels& labels) {
  const std::string colour = colour_of_agent(index);
  Vector2d before = Vector2d::Constant(std::numeric_limits<double>::infinity());
  for (double time_s = step_s; time_s <= agent.path.duration_s() + 1e-9; time_s += step_s) {
    const Vector2d at = view(pose_at(agent.path, time_s).position());
    if ((at - before).norm() < 2.0) continue;  // it waits
    before = at;
    svg.circle(at, 2.8, "fill=\"#fff\" stroke=\"" + colour + "\" stroke-width=\"1.5\"");
    labels.add_if_free(svg, at, svg_number(time_s), 9.0, "fill=\"" + colour + "\"");
  }
}

}  // namespace

PanelBox fitted_place(const PlanPicture& picture, const PanelBox& most) {
  const Bounds bounds = bounds_of(picture);
  const double scale = View{bounds, most}.scale();
  return {most.x, most.y, scale * (bounds.high.x() - bounds.low.x()), scale * (bounds.high.y() - bounds.low.y())};
}

void draw_place(Svg& svg, const PanelBox& box, const PlanPicture& picture) {
  const View view{bounds_of(picture), box};
  svg.define("<clipPath id=\"place\"><rect x=\"" + svg_number(box.x) + "\" y=\"" + svg_number(box.y) + "\" width=\"" +
             svg_number(box.width) + "\" height=\"" + svg_number(box.height) + "\"/></clipPath>");
  svg.begin_group("clip-path=\"url(#place)\"");
  svg.rectangle(box.x, box.y, box.width, box.height, "fill=\"#fff\"");
  draw_belief(svg, view, picture.belief);
  draw_walls(svg, view, picture.layers);
  Labels labels;
  for (std::size_t i = 0; i < picture.agents.size(); ++i) draw_path(svg, view, picture.agents[i], i);
  draw_sources(svg, view, picture, labels);
  double longest_s = 0.0;
  for (const PicturedAgent& agent : picture.agents) longest_s = std::max(longest_s, agent.path.duration_s());
  const double step_s = round_step(longest_s, kMostDots);
  for (std::size_t i = 0; i < picture.agents.size(); ++i) draw_start(svg, view, picture.agents[i], i, labels);
  for (std::size_t i = 0; i < picture.agents.size(); ++i) draw_dots(svg, view, picture.agents[i], i, step_s, labels);
  svg.end_group();
  // A scale: one metre, or five, or ten.
  const double bar_m = view.scale() > 25.0 ? 1.0 : view.scale() > 6.0 ? 5.0 : 10.0;
  const Vector2d end{box.x + box.width - 2.0, box.y + box.height + 8.0};
  const Vector2d begin{end.x() - view.scale() * bar_m, end.y()};
  svg.line(begin, end, "stroke=\"#222\" stroke-width=\"2\"");
  svg.text({begin.x() - 6.0, begin.y() + 4.0}, svg_number(bar_m) + " m", "text-anchor=\"end\" font-size=\"10\"");
  svg.text({box.x, end.y() + 4.0}, "dots: every " + svg_number(step_s) + " s", "font-size=\"10\"");
}

}  // namespace tandem::cli
