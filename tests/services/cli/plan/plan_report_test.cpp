#include "services/cli/plan/plan_report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace tandem::cli {
namespace {

const std::filesystem::path kScenarios = std::filesystem::path{TANDEM_SOURCE_DIR} / "config" / "scenarios";

bool go_on(double) {
  return true;
}

nlohmann::json report_of(const PlanningScenario& scenario, const PlanRequest& request) {
  return nlohmann::json::parse(plan_json(scenario, request, plan_scenario(scenario, request, go_on)));
}

/// Two rooms; the robot is asked to end in the other one.
PlanningScenario small_search() {
  return parse_planning_scenario(R"({
    "name": "two_rooms",
    "room": {"width_m": 10, "height_m": 5, "walls": [{"points": [[5, 0], [5, 3]]}]},
    "agents": [{"id": "robot", "kind": "robot", "start": [1, 1, 0], "radius_m": 0.3, "goal": [8, 2]},
               {"id": "person", "kind": "person", "start": [1, 2, 0], "latency_s": 2}],
    "search": {},
    "horizon_s": 60})",
                                 "two_rooms.json");
}

TEST(PlanReport, ASearchHasTheKeysThatProgramsRelyOn) {
  const auto json = report_of(small_search(), {.rollouts = 20});
  for (const char* key : {"planner", "value", "expected_time_s", "p_found", "lower_bound_s", "first_plan_ms",
                          "compute_ms", "role", "agents"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json.at("planner"), "tandem");
  EXPECT_EQ(json.at("role"), "leader_leader");  // the robot's goal alone is fixed
  EXPECT_GT(json.at("p_found"), 0.5);
  EXPECT_EQ(json.at("value"), json.at("expected_time_s"));
  ASSERT_EQ(json.at("agents").size(), 2U);
  const auto& robot = json.at("agents").at(0);
  EXPECT_EQ(robot.at("id"), "robot");
  EXPECT_EQ(robot.at("path").at(0), (nlohmann::json{0.0, 1.0, 1.0}));
  EXPECT_NEAR(robot.at("path").back().at(1).get<double>(), 8.0, 0.6);
  // The person reads for 2 s.
  const auto& path = json.at("agents").at(1).at("path");
  EXPECT_EQ(path.at(1), (nlohmann::json{2.0, 1.0, 2.0}));
  for (const auto& point : path) EXPECT_LE(point.at(0), 60.0);
}

TEST(PlanReport, EqualSeedsAndRolloutsGiveEqualPlans) {
  const auto one = report_of(small_search(), {.rollouts = 20, .seed = 3});
  EXPECT_EQ(report_of(small_search(), {.rollouts = 20, .seed = 3}).at("agents"), one.at("agents"));
}

TEST(PlanReport, EachPlannerPlansASearch) {
  for (const char* planner : {"greedy", "nearest_unseen", "lawnmower", "paper"}) {
    const auto json = report_of(small_search(), {.planner = planner, .rollouts = 5});
    EXPECT_EQ(json.at("planner"), planner);
    EXPECT_GT(json.at("p_found"), 0.3) << planner;
  }
}

TEST(PlanReport, ATaskTellsVisitsMessagesAndPools) {
  const auto scenario = load_planning_scenario(kScenarios / "tasks" / "light_and_panel_inform.json");
  const auto json = report_of(scenario, {.rollouts = 200});
  EXPECT_TRUE(json.at("expected_time_s").is_null());
  EXPECT_NEAR(json.at("value"), 10.5, 1e-6);  // 1 + 10 - 0.5
  EXPECT_EQ(json.at("proven"), true);
  EXPECT_EQ(json.at("informs"), nlohmann::json::parse(R"([{"agent": "mate", "source": "switch"}])"));
  EXPECT_EQ(json.at("agents").at(1).at("visits").at(0).at("source"), "switch");
  const auto& left = json.at("pools").at(1).at("left");
  EXPECT_EQ(left.front(), (nlohmann::json{0.0, 10.0}));
  EXPECT_EQ(left.back().at(1), 0.0);
}

TEST(PlanReport, PeopleReadATable) {
  const auto scenario = load_planning_scenario(kScenarios / "tasks" / "supermarket.json");
  const PlanRequest request{.rollouts = 200};
  const std::string text = plan_text(scenario, request, plan_scenario(scenario, request, go_on));
  EXPECT_NE(text.find("value 17.000, no plan is worth more"), std::string::npos) << text;
  EXPECT_LT(text.find("product"), text.rfind("cashier2"));
}

}  // namespace
}  // namespace tandem::cli
