#include "services/simulator/core/map_plan.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "services/common/strict_json.hpp"

namespace tandem::simulator {
namespace {

Eigen::Vector2d point(const std::vector<double>& two) {
  return {two[0], two[1]};
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + share * along)).norm();
}

bool is_inside(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& polygon) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[i];
    const auto& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

CellState state_at(const MapPlan& plan, const Eigen::Vector2d& p) {
  for (std::size_t i = 0; i < plan.outline.size(); ++i) {
    const auto& next = plan.outline[(i + 1) % plan.outline.size()];
    if (distance_to_segment(p, plan.outline[i], next) <= plan.outline_thickness_m / 2.0) return CellState::Occupied;
  }
  for (const auto& wall : plan.walls) {
    if (distance_to_segment(p, wall.from, wall.to) <= wall.thickness_m / 2.0) return CellState::Occupied;
  }
  for (const auto& block : plan.blocks) {
    if ((p.array() >= block.min.array()).all() && (p.array() <= block.max.array()).all()) return CellState::Occupied;
  }
  return is_inside(p, plan.outline) ? CellState::Free : CellState::Unknown;
}

void add_columns(StrictObject lattice, std::vector<PlanBlock>& blocks) {
  const Eigen::Vector2d first = point(lattice.numbers("first", 2));
  const Eigen::Vector2d pitch = point(lattice.numbers("pitch", 2));
  const auto count = lattice.numbers("count", 2);
  const double half = lattice.number("size_m", {0.05, 5.0}) / 2.0;
  lattice.refuse_unknown_keys();
  for (int row = 0; row < static_cast<int>(count[1]); ++row) {
    for (int column = 0; column < static_cast<int>(count[0]); ++column) {
      const Eigen::Vector2d centre = first + Eigen::Vector2d{column * pitch.x(), row * pitch.y()};
      blocks.push_back({centre - Eigen::Vector2d{half, half}, centre + Eigen::Vector2d{half, half}});
    }
  }
}

}  // namespace

MapPlan parse_map_plan(std::string_view json, const std::string& file_name) {
  const nlohmann::json document = parse_json(json, file_name);
  StrictObject root{document, file_name};
  MapPlan plan;
  plan.resolution_m = root.number_or("resolution_m", plan.resolution_m, {0.01, 1.0});
  plan.margin_m = root.number_or("margin_m", plan.margin_m, {0.0, 100.0});
  plan.outline_thickness_m = root.number_or("outline_thickness_m", plan.outline_thickness_m, {0.1, 5.0});
  for (const auto& corner : root.rows("outline", 2)) plan.outline.push_back(point(corner));
  if (plan.outline.size() < 3) throw ConfigError(file_name + ": outline: needs three corners or more");
  for (auto& wall : root.objects("walls")) {
    plan.walls.push_back(
        {point(wall.numbers("from", 2)), point(wall.numbers("to", 2)), wall.number_or("thickness_m", 0.2, {0.1, 5.0})});
    wall.refuse_unknown_keys();
  }
  for (auto& block : root.objects("blocks")) {
    plan.blocks.push_back({point(block.numbers("min", 2)), point(block.numbers("max", 2))});
    block.refuse_unknown_keys();
  }
  for (const auto& lattice : root.objects("columns")) add_columns(lattice, plan.blocks);
  root.refuse_unknown_keys();
  return plan;
}

OccupancyGrid draw(const MapPlan& plan) {
  Eigen::Vector2d low = plan.outline.front();
  Eigen::Vector2d high = low;
  for (const auto& corner : plan.outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low -= Eigen::Vector2d::Constant(plan.margin_m);
  high += Eigen::Vector2d::Constant(plan.margin_m);
  OccupancyGrid map{static_cast<int>(std::lround((high.x() - low.x()) / plan.resolution_m)),
                    static_cast<int>(std::lround((high.y() - low.y()) / plan.resolution_m)), plan.resolution_m,
                    Pose2{low.x(), low.y(), 0.0}};
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      map.set({column, row}, state_at(plan, map.centre_in_map({column, row})));
    }
  }
  return map;
}

double free_area_m2(const OccupancyGrid& map) {
  const auto free_cells = std::count(map.cells().begin(), map.cells().end(), CellState::Free);
  return static_cast<double>(free_cells) * map.resolution_m() * map.resolution_m();
}

}  // namespace tandem::simulator
