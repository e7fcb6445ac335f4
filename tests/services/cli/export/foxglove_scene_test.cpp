#include "services/cli/export/foxglove_scene.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/cli/export/base64.hpp"
#include "services/cli/export/foxglove_schemas.hpp"

namespace tandem::cli {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kTime_ns = 7'000'000'005;

template <class PubSubType>
std::vector<FoxgloveMessage> shown(const Topic<PubSubType>& topic, const typename PubSubType::type& message) {
  return foxglove_messages(std::string{topic.name}, bus::encode<PubSubType>(message), kTime_ns);
}

TEST(FoxgloveScene, ARobotsPoseIsATransformAndABody) {
  msg::RobotPose pose;
  pose.robot("robot1");
  pose.map_from_base().x(3.0);
  pose.map_from_base().heading(std::numbers::pi);
  const auto messages = shown(topic::kRobotPose, pose);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].topic, "/tf");
  EXPECT_EQ(messages[0].schema, "foxglove.FrameTransform");
  const Json transform = Json::parse(messages[0].json);
  EXPECT_EQ(transform.at("parent_frame_id"), "map");
  EXPECT_EQ(transform.at("child_frame_id"), "robot1");
  EXPECT_EQ(transform.at("translation").at("x"), 3.0);
  EXPECT_NEAR(transform.at("rotation").at("z"), 1.0, 1e-12);
  EXPECT_EQ(transform.at("timestamp"), Json::parse(R"({"sec": 7, "nsec": 5})"));
  EXPECT_EQ(Json::parse(messages[1].json).at("entities").at(0).at("texts").at(0).at("text"), "robot1");
}

TEST(FoxgloveScene, ABeamWithoutReturnIsNoPoint) {
  msg::LaserScan scan;
  scan.robot("robot1");
  scan.angle_min_rad(0.0);
  scan.angle_increment_rad(0.1);
  scan.ranges_m({std::numeric_limits<float>::quiet_NaN(), 2.0F});
  const Json cloud = Json::parse(shown(topic::kScan, scan).at(0).json);
  EXPECT_EQ(cloud.at("frame_id"), "robot1");
  EXPECT_EQ(cloud.at("data").get<std::string>().size(), 16U);  // one point of 12 bytes
}

TEST(FoxgloveScene, FreeCellsOfTheMapAreWhiteOccupiedOnesBlack) {
  msg::OccupancyGrid map;
  map.width(2);
  map.height(1);
  map.resolution_m(0.5);
  map.cells({0, 100});
  const Json grid = Json::parse(shown(topic::kMap, map).at(0).json);
  EXPECT_EQ(grid.at("data"), base64_of(std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 255}));
  EXPECT_EQ(grid.at("row_stride"), 8);
  EXPECT_EQ(grid.at("column_count"), 2);
}

TEST(FoxgloveScene, APlanIsALineForEachAgent) {
  msg::TeamPlan plan;
  plan.robot("robot1");
  msg::PlannedPath path;
  path.agent("person1");
  msg::TimedPoint point;
  point.x_m(1.0);
  path.points({point, point, point});
  plan.paths({path, path});
  const Json update = Json::parse(shown(topic::kTeamPlan, plan).at(0).json);
  EXPECT_EQ(update.at("entities").size(), 2U);
  EXPECT_EQ(update.at("entities").at(0).at("lines").at(0).at("points").size(), 3U);
}

TEST(FoxgloveScene, WhatHasNoPlaceInItOrIsBrokenIsNotShown) {
  EXPECT_TRUE(shown(topic::kLinkStatus, {}).empty());
  EXPECT_TRUE(foxglove_messages("map", mcap::Bytes{0, 1, 0, 0, 9}, 0).empty());
}

TEST(FoxgloveSchemas, NameEveryFieldOfWhatIsWritten) {
  msg::TeammateState mate;
  mate.agent("person1");
  for (const FoxgloveMessage& message : shown(topic::kTeammates, mate)) {
    const Json schema = Json::parse(foxglove_schema(message.schema));
    EXPECT_EQ(schema.at("title"), message.schema);
    const Json written = Json::parse(message.json);
    for (const auto& [name, value] : written.items()) {
      EXPECT_TRUE(schema.at("properties").contains(name)) << name;
    }
  }
  EXPECT_THROW((void)foxglove_schema("foxglove.Unknown"), std::invalid_argument);
}

}  // namespace
}  // namespace tandem::cli
