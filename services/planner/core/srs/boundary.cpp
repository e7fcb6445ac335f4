#include "services/planner/core/srs/boundary.hpp"

#include <cmath>

namespace tandem {
namespace {

struct ProblemOf {
  using Answer = std::optional<std::string>;
  Answer operator()(const Nowhere&) const { return std::nullopt; }
  Answer operator()(const Disc& shape) const { return problem_of(PlanarShape{shape}); }
  Answer operator()(const Polygon& shape) const { return problem_of(PlanarShape{shape}); }
  Answer operator()(const Corridor& shape) const { return problem_of(PlanarShape{shape}); }
  Answer operator()(const HalfPlane& shape) const { return problem_of(PlanarShape{shape}); }
  Answer operator()(const NamedArea& area) const {
    const auto problem = problem_of(PlanarShape{area.outline});
    return problem ? Answer{"area " + area.name + ": " + *problem} : std::nullopt;
  }
  Answer operator()(const Attached& attached) const { return problem_of(attached.shape_in_agent); }
  Answer operator()(const Between& between) const {
    if (!between.from.point_in_map.allFinite() || !between.to.point_in_map.allFinite() ||
        !std::isfinite(between.half_width_m)) {
      return "its numbers must be finite";
    }
    if (!(between.half_width_m > 0.0)) return "half_width_m must be greater than 0";
    if (between.from == between.to) return "its two ends are the same: the corridor has no length";
    return std::nullopt;
  }
  Answer operator()(const SpeedInterval& speeds) const {
    if (!(speeds.min_mps >= 0.0) || !(speeds.max_mps > speeds.min_mps)) {
      return "min_mps must not be negative, and max_mps greater";
    }
    return std::nullopt;
  }
  Answer operator()(const Sphere& sphere) const {
    if (!sphere.centre_in_map.allFinite() || !std::isfinite(sphere.radius_m)) return "its numbers must be finite";
    if (!(sphere.radius_m > 0.0)) return "radius_m must be greater than 0";
    return std::nullopt;
  }
  Answer operator()(const Box& box) const {
    if (!box.low_in_map.allFinite() || !box.high_in_map.allFinite()) return "its numbers must be finite";
    if (!(box.low_in_map.array() < box.high_in_map.array()).all()) return "each number of high must be above low's";
    return std::nullopt;
  }
};

}  // namespace

SearchSpace search_space_of(const Boundary& boundary) {
  if (std::holds_alternative<Nowhere>(boundary)) return SearchSpace::None;
  if (std::holds_alternative<SpeedInterval>(boundary)) return SearchSpace::Speed;
  if (std::holds_alternative<Sphere>(boundary) || std::holds_alternative<Box>(boundary)) return SearchSpace::Volume;
  return SearchSpace::Plane;
}

std::optional<PlanarShape> shape_in_map(const Boundary& boundary) {
  if (const auto* disc = std::get_if<Disc>(&boundary)) return *disc;
  if (const auto* polygon = std::get_if<Polygon>(&boundary)) return *polygon;
  if (const auto* corridor = std::get_if<Corridor>(&boundary)) return *corridor;
  if (const auto* half_plane = std::get_if<HalfPlane>(&boundary)) return *half_plane;
  if (const auto* area = std::get_if<NamedArea>(&boundary)) return area->outline;
  return std::nullopt;
}

std::optional<std::string> problem_of(const Boundary& boundary) {
  return std::visit(ProblemOf{}, boundary);
}

}  // namespace tandem
