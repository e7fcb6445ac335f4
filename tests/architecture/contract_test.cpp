#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "idl/topics.hpp"
#include "tests/architecture/source_tree.hpp"

namespace tandem::test {
namespace {

/// Body of each struct in the IDL files, by name.
std::map<std::string, std::string> idl_structs() {
  std::map<std::string, std::string> structs;
  for (const auto& file : files_below("idl", ".idl")) {
    std::ifstream stream{source_root() / file};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    const std::regex pattern{R"((@final\s+)?struct\s+(\w+)\s*\{([^}]*)\})"};
    for (auto match = std::sregex_iterator{text.begin(), text.end(), pattern}; match != std::sregex_iterator{};
         ++match) {
      EXPECT_TRUE((*match)[1].matched) << file << ": struct " << (*match)[2] << " is not @final";
      structs[(*match)[2]] = (*match)[3];
    }
  }
  return structs;
}

std::string struct_of(const TopicInfo& topic) {
  const std::string type = topic.make_type()->getName();
  return type.substr(type.rfind(':') + 1);
}

TEST(Contract, HasAtMostEightIdlFiles) {
  EXPECT_LE(files_below("idl", ".idl").size(), 8U);
}

TEST(Contract, EveryTopicOfTheTableIsListedOnce) {
  std::set<std::string_view> names;
  for (const auto& topic : all_topics()) EXPECT_TRUE(names.insert(topic.name).second) << topic.name;

  std::size_t declared = 0;
  for (const auto& line : lines_of_sources({"idl"})) {
    declared += line.text.starts_with("inline constexpr Topic<") ? 1 : 0;
  }
  EXPECT_EQ(names.size(), declared);
}

TEST(Contract, AVelocityNeverCrossesTheLink) {
  for (const auto& topic : all_topics()) {
    if (topic.delivery == Delivery::Command) {
      EXPECT_EQ(topic.relay.direction, Relay::Direction::None) << topic.name;
    }
  }
}

TEST(Contract, EveryEventHasAnIdAndThoseThatAreAnsweredNameTheirAppliers) {
  const auto structs = idl_structs();
  const std::set<std::string_view> unanswered{"message_receipt", "reminder", "questionnaire_answer"};
  for (const auto& topic : all_topics()) {
    if (topic.delivery != Delivery::Event) continue;
    EXPECT_NE(structs.at(struct_of(topic)).find("string id;"), std::string::npos) << topic.name;
    EXPECT_EQ(topic.appliers.empty(), unanswered.contains(topic.name)) << topic.name;
  }
}

TEST(Contract, EveryTopicOfTheRobotIsKeyedByIt) {
  const auto structs = idl_structs();
  for (const auto* topic : {"odometry", "base_status", "sonar", "velocity_command", "scan", "camera_image", "people",
                            "robot_pose", "plan_execution", "detection", "team_plan"}) {
    for (const auto& info : all_topics()) {
      if (info.name != topic) continue;
      EXPECT_NE(structs.at(struct_of(info)).find("@key string robot;"), std::string::npos) << topic;
    }
  }
}

TEST(Contract, GeneratedDeserializersCatchWhateverABadSampleThrows) {
  std::size_t catches = 0;
  const std::filesystem::path generated = std::filesystem::path{TANDEM_BINARY_DIR} / "idl" / "generated";
  for (const auto& entry : std::filesystem::directory_iterator(generated)) {
    if (!entry.path().string().ends_with("PubSubTypes.cxx")) continue;
    std::ifstream stream{entry.path()};
    for (std::string line; std::getline(stream, line);) {
      EXPECT_EQ(line.find("catch (eprosima"), std::string::npos) << entry.path() << ": " << line;
      catches += line.find("catch (...)") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GE(catches, 2 * all_topics().size());  // serialize and deserialize of each
}

}  // namespace
}  // namespace tandem::test
