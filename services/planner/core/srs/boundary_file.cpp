#include "services/planner/core/srs/boundary_file.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace tandem {
namespace {

using nlohmann::json;

constexpr Range kLength{-1e6, 1e6};

Eigen::Vector2d planar(const std::vector<double>& two) {
  return {two[0], two[1]};
}

Eigen::Vector3d spatial(const std::vector<double>& three) {
  return {three[0], three[1], three[2]};
}

std::vector<Eigen::Vector2d> points_from(StrictObject& object, std::string_view key) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& row : object.rows(key, 2)) points.push_back(planar(row));
  return points;
}

PlanarShape shape_from(StrictObject& object, const std::string& word) {
  if (word == "disc") return Disc{planar(object.numbers("centre", 2)), object.number("radius_m", kLength)};
  if (word == "polygon") return Polygon{points_from(object, "corners")};
  if (word == "corridor") return Corridor{points_from(object, "points"), object.number("half_width_m", kLength)};
  return HalfPlane{planar(object.numbers("point", 2)), planar(object.numbers("outward", 2))};
}

Anchor anchor_from(StrictObject object) {
  Anchor anchor;
  if (object.has("agent") == object.has("point")) object.fail("agent", "give either agent or point");
  if (object.has("agent")) anchor.agent = object.text("agent");
  if (object.has("point")) anchor.point_in_map = planar(object.numbers("point", 2));
  object.refuse_unknown_keys();
  return anchor;
}

Boundary any_boundary_from(StrictObject& object, const NamedAreas& areas) {
  const std::string word = object.text_or("shape", "",
                                          {"nowhere", "disc", "polygon", "corridor", "half_plane", "area", "attached",
                                           "between", "speed", "sphere", "box"});
  if (word == "nowhere") return Nowhere{};
  if (word == "area") {
    const std::string name = object.text("area");
    const auto found = areas.find(name);
    if (found != areas.end()) return NamedArea{name, found->second};
    std::string known;
    for (const auto& [one, outline] : areas) known += (known.empty() ? "" : ", ") + one;
    object.fail("area", "no area is called \"" + name + "\"; known: " + known);
  }
  if (word == "attached") {
    StrictObject shape = object.object("shape_in_agent");
    Attached attached{object.text("agent"), {}};
    attached.shape_in_agent =
        shape_from(shape, shape.text_or("shape", "", {"disc", "polygon", "corridor", "half_plane"}));
    shape.refuse_unknown_keys();
    return attached;
  }
  if (word == "between") {
    return Between{anchor_from(object.object("from")), anchor_from(object.object("to")),
                   object.number("half_width_m", kLength)};
  }
  if (word == "speed") {
    return SpeedInterval{object.number("min_mps", kLength),
                         object.number_or("max_mps", std::numeric_limits<double>::infinity(), kLength)};
  }
  if (word == "sphere") return Sphere{spatial(object.numbers("centre", 3)), object.number("radius_m", kLength)};
  if (word == "box") return Box{spatial(object.numbers("low", 3)), spatial(object.numbers("high", 3))};
  const PlanarShape shape = shape_from(object, word);
  return std::visit([](const auto& one) { return Boundary{one}; }, shape);
}

json json_of_point(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

json json_of_point(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

json json_of_anchor(const Anchor& anchor) {
  if (!anchor.agent.empty()) return {{"agent", anchor.agent}};
  return {{"point", json_of_point(anchor.point_in_map)}};
}

struct JsonOf {
  json operator()(const Nowhere&) const { return {{"shape", "nowhere"}}; }
  json operator()(const Disc& disc) const {
    return {{"shape", "disc"}, {"centre", json_of_point(disc.centre)}, {"radius_m", disc.radius_m}};
  }
  json operator()(const Polygon& polygon) const {
    return {{"shape", "polygon"}, {"corners", json_of(polygon.corners)}};
  }
  json operator()(const Corridor& corridor) const {
    return {{"shape", "corridor"}, {"points", json_of(corridor.points)}, {"half_width_m", corridor.half_width_m}};
  }
  json operator()(const HalfPlane& half_plane) const {
    return {{"shape", "half_plane"},
            {"point", json_of_point(half_plane.point)},
            {"outward", json_of_point(half_plane.outward)}};
  }
  json operator()(const NamedArea& area) const { return {{"shape", "area"}, {"area", area.name}}; }
  json operator()(const Attached& attached) const {
    return {{"shape", "attached"},
            {"agent", attached.agent},
            {"shape_in_agent", std::visit(JsonOf{}, attached.shape_in_agent)}};
  }
  json operator()(const Between& between) const {
    return {{"shape", "between"},
            {"from", json_of_anchor(between.from)},
            {"to", json_of_anchor(between.to)},
            {"half_width_m", between.half_width_m}};
  }
  json operator()(const SpeedInterval& speeds) const {
    json object{{"shape", "speed"}, {"min_mps", speeds.min_mps}};
    if (std::isfinite(speeds.max_mps)) object["max_mps"] = speeds.max_mps;
    return object;
  }
  json operator()(const Sphere& sphere) const {
    return {{"shape", "sphere"}, {"centre", json_of_point(sphere.centre_in_map)}, {"radius_m", sphere.radius_m}};
  }
  json operator()(const Box& box) const {
    return {{"shape", "box"}, {"low", json_of_point(box.low_in_map)}, {"high", json_of_point(box.high_in_map)}};
  }
};

}  // namespace

Boundary boundary_from(StrictObject object, const NamedAreas& areas) {
  (void)object.text("shape");  // there is no usual one
  Boundary boundary = any_boundary_from(object, areas);
  object.refuse_unknown_keys();
  return boundary;
}

json json_of(const Boundary& boundary) {
  return std::visit(JsonOf{}, boundary);
}

json json_of(const std::vector<Eigen::Vector2d>& points) {
  json list = json::array();
  for (const auto& point : points) list.push_back(json_of_point(point));
  return list;
}

}  // namespace tandem
