#include "services/cli/plan/plan_picture.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "services/cli/plan/plan_report.hpp"

namespace tandem::cli {
namespace {

/// Whether each element is closed in its turn and no text holds a bare sign.
testing::AssertionResult is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return testing::AssertionFailure() << "no end: " << text.substr(at, 40);
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return testing::AssertionFailure() << "bare <: " << tag;
    if (std::ranges::count(tag, '"') % 2 != 0) return testing::AssertionFailure() << "quotes: " << tag;
    const std::string name =
        tag.substr(tag.starts_with('/') ? 1 : 0, tag.find_first_of(" /", 1) - (tag.starts_with('/') ? 1 : 0));
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) return testing::AssertionFailure() << "closes " << tag;
      open.pop_back();
    } else if (!tag.ends_with('/')) {
      open.push_back(name);
    }
    at = end;
  }
  if (!open.empty()) return testing::AssertionFailure() << "not closed: " << open.back();
  for (std::size_t at = 0; (at = text.find('&', at)) != std::string::npos; ++at) {
    if (text.find(';', at) > at + 6) return testing::AssertionFailure() << "bare &";
  }
  return testing::AssertionSuccess();
}

std::string picture_of_file(const std::string& name) {
  const auto scenario = load_planning_scenario(std::filesystem::path{TANDEM_SOURCE_DIR} / "config/scenarios" / name);
  const PlanRequest request{.rollouts = 50};
  const auto planned = plan_scenario(scenario, request, [](double) { return true; });
  return svg_of(picture_of(scenario, request, planned));
}

TEST(PlanPicture, ShowsEachSourceAndEachAgentOfEachTask) {
  const auto folder = std::filesystem::path{TANDEM_SOURCE_DIR} / "config/scenarios/tasks";
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto scenario = load_planning_scenario(entry.path());
    const std::string svg = picture_of_file("tasks/" + entry.path().filename().string());
    EXPECT_TRUE(is_well_formed(svg)) << entry.path();
    for (const auto& source : scenario.world.sources) {
      EXPECT_NE(svg.find(">" + source.id + "</text>"), std::string::npos) << source.id;
    }
    for (const auto& agent : scenario.agents) {
      EXPECT_NE(svg.find(">" + agent.searcher.id + "</text>"), std::string::npos) << agent.searcher.id;
    }
    ++pictures;
  }
  EXPECT_GE(pictures, 10);
}

TEST(PlanPicture, EqualPlansAreEqualBytes) {
  EXPECT_EQ(picture_of_file("tasks/supermarket.json"), picture_of_file("tasks/supermarket.json"));
}

TEST(PlanPicture, NamesMayHoldSignsThatMeanSomethingInXml) {
  PlanPicture picture;
  picture.title = "a < b & \"c\"";
  picture.layers = {OccupancyGrid{4, 4, 0.5, {}, CellState::Free}};
  picture.agents.push_back({"<robot>", ScenarioAgentKind::Robot, {1.0, 1.0, 0.0}, {}, {}});
  picture.world.agents = {"<robot>"};
  RewardSource source;
  source.id = "R&D";
  source.boundary = Disc{{1.0, 1.5}, 0.2};
  picture.world.sources.push_back(source);
  const std::string svg = svg_of(picture);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_NE(svg.find("R&amp;D"), std::string::npos);
}

}  // namespace
}  // namespace tandem::cli
