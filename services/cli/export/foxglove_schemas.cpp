#include "services/cli/export/foxglove_schemas.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tandem::cli {
namespace {

using Json = nlohmann::ordered_json;
using Properties = std::vector<std::pair<std::string, Json>>;

Json object(const std::string& title, const Properties& properties) {
  Json schema{{"type", "object"}};
  if (!title.empty()) schema["title"] = title;
  Json names = Json::array();
  for (const auto& [name, property] : properties) {
    schema["properties"][name] = property;
    names.push_back(name);
  }
  schema["required"] = names;
  return schema;
}

Json list_of(const Json& items) {
  return {{"type", "array"}, {"items", items}};
}

const Json kNumber{{"type", "number"}};
const Json kInteger{{"type", "integer"}};
const Json kCount{{"type", "integer"}, {"minimum", 0}};
const Json kText{{"type", "string"}};
const Json kBytes{{"type", "string"}, {"contentEncoding", "base64"}};
const Json kFlag{{"type", "boolean"}};

Json time() {
  return object("time", {{"sec", kCount}, {"nsec", kCount}});
}
Json duration() {
  return object("duration", {{"sec", kInteger}, {"nsec", kCount}});
}
Json vector3() {
  return object("foxglove.Vector3", {{"x", kNumber}, {"y", kNumber}, {"z", kNumber}});
}
Json point3() {
  return object("foxglove.Point3", {{"x", kNumber}, {"y", kNumber}, {"z", kNumber}});
}
Json quaternion() {
  return object("foxglove.Quaternion", {{"x", kNumber}, {"y", kNumber}, {"z", kNumber}, {"w", kNumber}});
}
Json pose() {
  return object("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}
Json colour() {
  return object("foxglove.Color", {{"r", kNumber}, {"g", kNumber}, {"b", kNumber}, {"a", kNumber}});
}
Json packed_field() {
  return object("foxglove.PackedElementField", {{"name", kText}, {"offset", kCount}, {"type", kInteger}});
}

Json scene_entity() {
  const Json arrow = object("foxglove.ArrowPrimitive", {{"pose", pose()},
                                                        {"shaft_length", kNumber},
                                                        {"shaft_diameter", kNumber},
                                                        {"head_length", kNumber},
                                                        {"head_diameter", kNumber},
                                                        {"color", colour()}});
  const Json cube = object("foxglove.CubePrimitive", {{"pose", pose()}, {"size", vector3()}, {"color", colour()}});
  const Json sphere = object("foxglove.SpherePrimitive", {{"pose", pose()}, {"size", vector3()}, {"color", colour()}});
  const Json cylinder = object(
      "foxglove.CylinderPrimitive",
      {{"pose", pose()}, {"size", vector3()}, {"bottom_scale", kNumber}, {"top_scale", kNumber}, {"color", colour()}});
  const Json line = object("foxglove.LinePrimitive", {{"type", kInteger},
                                                      {"pose", pose()},
                                                      {"thickness", kNumber},
                                                      {"scale_invariant", kFlag},
                                                      {"points", list_of(point3())},
                                                      {"color", colour()},
                                                      {"colors", list_of(colour())},
                                                      {"indices", list_of(kCount)}});
  const Json triangles = object("foxglove.TriangleListPrimitive", {{"pose", pose()},
                                                                   {"points", list_of(point3())},
                                                                   {"color", colour()},
                                                                   {"colors", list_of(colour())},
                                                                   {"indices", list_of(kCount)}});
  const Json label = object("foxglove.TextPrimitive", {{"pose", pose()},
                                                       {"billboard", kFlag},
                                                       {"font_size", kNumber},
                                                       {"scale_invariant", kFlag},
                                                       {"color", colour()},
                                                       {"text", kText}});
  const Json model = object("foxglove.ModelPrimitive", {{"pose", pose()},
                                                        {"scale", vector3()},
                                                        {"color", colour()},
                                                        {"override_color", kFlag},
                                                        {"url", kText},
                                                        {"media_type", kText},
                                                        {"data", kBytes}});
  return object("foxglove.SceneEntity",
                {{"timestamp", time()},
                 {"frame_id", kText},
                 {"id", kText},
                 {"lifetime", duration()},
                 {"frame_locked", kFlag},
                 {"metadata", list_of(object("foxglove.KeyValuePair", {{"key", kText}, {"value", kText}}))},
                 {"arrows", list_of(arrow)},
                 {"cubes", list_of(cube)},
                 {"spheres", list_of(sphere)},
                 {"cylinders", list_of(cylinder)},
                 {"lines", list_of(line)},
                 {"triangles", list_of(triangles)},
                 {"texts", list_of(label)},
                 {"models", list_of(model)}});
}

Json scene_update() {
  const Json deletion =
      object("foxglove.SceneEntityDeletion", {{"timestamp", time()}, {"type", kInteger}, {"id", kText}});
  return object("foxglove.SceneUpdate", {{"deletions", list_of(deletion)}, {"entities", list_of(scene_entity())}});
}

Json grid() {
  return object("foxglove.Grid", {{"timestamp", time()},
                                  {"frame_id", kText},
                                  {"pose", pose()},
                                  {"column_count", kCount},
                                  {"cell_size", object("foxglove.Vector2", {{"x", kNumber}, {"y", kNumber}})},
                                  {"row_stride", kCount},
                                  {"cell_stride", kCount},
                                  {"fields", list_of(packed_field())},
                                  {"data", kBytes}});
}

Json point_cloud() {
  return object("foxglove.PointCloud", {{"timestamp", time()},
                                        {"frame_id", kText},
                                        {"pose", pose()},
                                        {"point_stride", kCount},
                                        {"fields", list_of(packed_field())},
                                        {"data", kBytes}});
}

Json frame_transform() {
  return object("foxglove.FrameTransform", {{"timestamp", time()},
                                            {"parent_frame_id", kText},
                                            {"child_frame_id", kText},
                                            {"translation", vector3()},
                                            {"rotation", quaternion()}});
}

}  // namespace

std::string foxglove_schema(const std::string& name) {
  if (name == "foxglove.SceneUpdate") return scene_update().dump();
  if (name == "foxglove.Grid") return grid().dump();
  if (name == "foxglove.PointCloud") return point_cloud().dump();
  if (name == "foxglove.FrameTransform") return frame_transform().dump();
  throw std::invalid_argument(name + " is no schema that is written here");
}

}  // namespace tandem::cli
