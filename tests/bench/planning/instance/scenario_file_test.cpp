#include "bench/planning/instance/scenario_file.hpp"

#include <gtest/gtest.h>

#include "bench/planning/instance/prior.hpp"
#include "services/planner/core/scenario/planning_scenario.hpp"

namespace tandem::bench {
namespace {

TEST(ScenarioFile, ReadsBackAsTheInstance) {
  for (const auto& family : {"S1u", "S1x", "S4", "S8d", "S1l3"}) {
    const PlanningInstance instance = instance_of(family, 3);
    const PlanningScenario scenario = parse_planning_scenario(scenario_json(instance), "frozen.json");
    ASSERT_EQ(scenario.agents.size(), instance.searchers.size()) << family;
    for (std::size_t m = 0; m < scenario.agents.size(); ++m) {
      EXPECT_NEAR(scenario.agents[m].start.x, instance.starts[m].x, 1e-3);
      EXPECT_DOUBLE_EQ(scenario.agents[m].searcher.speed_mps, instance.searchers[m].speed_mps);
      EXPECT_DOUBLE_EQ(scenario.agents[m].searcher.view_max_m, instance.searchers[m].view_max_m);
    }
    const auto maps = tandem::layers_of(scenario);
    EXPECT_EQ(maps.size(), layers_of(instance).size()) << family;
  }
}

TEST(ScenarioFile, HoldsThePriorOfItsInstance) {
  const PlanningInstance instance = instance_of("S8d", 3);
  const PlanningScenario scenario = parse_planning_scenario(scenario_json(instance), "frozen.json");
  const SearchArea area(layers_of(instance).front(), instance.area);
  std::vector<Eigen::Vector2d> points;
  std::vector<double> floors_m2;
  for (int cell = 0; cell < area.size(); ++cell) {
    points.push_back(area.point(cell));
    floors_m2.push_back(area.floor_m2(cell));
  }
  const auto read = tandem::prior_of(*scenario.search, instance.area.start_in_map, points, floors_m2);
  const auto own = prior_of(instance.prior, area, instance.area.start_in_map,
                            std::vector<bool>(static_cast<std::size_t>(area.size()), true));
  double difference = 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) difference += std::abs(own[i] - read[i]);
  // Its hills are cut at the walls and count whole, ours keep their weights: alike, not equal.
  EXPECT_LT(difference, 0.4);
}

}  // namespace
}  // namespace tandem::bench
