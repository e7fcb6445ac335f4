#include "services/mapping/core/map_areas.hpp"

#include <nlohmann/json.hpp>

#include "services/common/file_io.hpp"
#include "services/common/strict_json.hpp"

namespace tandem {
namespace {

std::vector<Eigen::Vector2d> corners_from(StrictObject& object, std::string_view key) {
  std::vector<Eigen::Vector2d> corners;
  for (const auto& corner : object.rows(key, 2)) corners.emplace_back(corner[0], corner[1]);
  if (corners.size() < 3) object.fail(key, "a polygon needs at least three corners");
  return corners;
}

MapArea area_with_rule(StrictObject object, const std::string& name) {
  MapArea area{.name = name, .corners_in_map = corners_from(object, "corners")};
  static_cast<void>(object.text("rule"));  // there is no usual one
  if (object.text_or("rule", "", {"keep_out", "slow"}) == "slow") {
    area.rule = AreaRule::Slow;
    area.max_speed_mps = object.number("max_speed_mps", {0.05, 0.7});
  } else {
    area.rule = AreaRule::KeepOut;
    if (object.has("max_speed_mps")) object.fail("max_speed_mps", "goes with the rule slow");
  }
  object.refuse_unknown_keys();
  return area;
}

}  // namespace

std::vector<MapArea> parse_map_areas(std::string_view json, const std::string& file_name) {
  const nlohmann::json document = parse_json(json, file_name);
  StrictObject object{document, file_name};
  std::vector<MapArea> areas;
  for (const auto& name : object.names()) {
    areas.push_back(document.at(name).is_object()
                        ? area_with_rule(object.object(name), name)
                        : MapArea{.name = name, .corners_in_map = corners_from(object, name)});
  }
  return areas;
}

std::vector<MapArea> load_map_areas(const std::filesystem::path& map_yaml) {
  const auto file = map_yaml.parent_path() / "areas.json";
  return std::filesystem::exists(file) ? parse_map_areas(read_file(file), file.string()) : std::vector<MapArea>{};
}

}  // namespace tandem
