#include "services/planner/core/srs/boundary_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "services/common/config.hpp"

namespace tandem {
namespace {

const NamedAreas kAreas{{"kitchen", Polygon{{{0, 0}, {2, 0}, {0, 2}}}}};

Boundary read(const nlohmann::json& object) {
  return boundary_from(StrictObject(object, "world.json: boundary"), kAreas);
}

TEST(BoundaryFile, ReadsWhatItWritesOfEveryKind) {
  const std::vector<Boundary> all{
      Nowhere{},
      Disc{{1, 2}, 3.0},
      Polygon{{{0, 0}, {1, 0}, {0, 1}}},
      Corridor{{{0, 0}, {1, 0}, {1, 1}}, 0.5},
      HalfPlane{{1, 2}, {0, 1}},
      NamedArea{"kitchen", kAreas.at("kitchen")},
      Attached{"person", HalfPlane{{-1, 0}, {-1, 0}}},
      Between{{"person", {0, 0}}, {"", {5, 5}}, 0.3},
      SpeedInterval{1.5, std::numeric_limits<double>::infinity()},
      SpeedInterval{0.5, 1.0},
      Sphere{{1, 2, 3}, 4.0},
      Box{{0, 0, 0}, {1, 2, 3}},
  };
  for (const Boundary& boundary : all) {
    const nlohmann::json written = json_of(boundary);
    EXPECT_EQ(read(written), boundary) << written;
  }
}

TEST(BoundaryFile, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {R"({"shape": "ring"})", "ring"},
      {R"({"shape": "disc", "centre": [0, 0]})", "radius_m"},
      {R"({"shape": "disc", "centre": [0, 0, 0], "radius_m": 1})", "centre"},
      {R"({"shape": "area", "area": "hall"})", "kitchen"},
      {R"({"shape": "between", "from": {"agent": "a", "point": [0, 0]}, "to": {"agent": "b"}, "half_width_m": 1})",
       "either agent or point"},
  };
  for (const auto& [text, expected] : cases) {
    try {
      (void)read(nlohmann::json::parse(text));
      ADD_FAILURE() << text << " was read";
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string{error.what()}.find("world.json"), std::string::npos) << error.what();
      EXPECT_NE(std::string{error.what()}.find(expected), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace tandem
