#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "services/common/random.hpp"
#include "services/planner/core/search/forecast.hpp"
#include "services/planner/core/search/search_belief.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

SearchAreaOptions start_at(double x, double y) {
  SearchAreaOptions options;
  options.start_in_map = {x, y};
  return options;
}

Searcher camera() {
  Searcher robot;
  robot.id = "robot";
  robot.view_min_m = 0.6;
  robot.view_max_m = 4.0;
  robot.field_of_view_rad = from_degrees(60.0);
  robot.detection_rate_per_s = 1.0;
  return robot;
}

TEST(SearchArea, CoversTheFloorThatCanBeWalkedTo) {
  // Two rooms of 2 m x 2 m with a wall between them.
  const OccupancyGrid map = room({"##########", "#....#...#", "#....#...#", "#....#...#", "#....#...#", "##########"});
  const SearchArea area(map, start_at(1.5, 1.5));

  EXPECT_NEAR(area.area_m2(), 4.0, 0.3);
  EXPECT_TRUE(area.cell_at({1.5, 1.5}));
  EXPECT_FALSE(area.cell_at({3.8, 1.5}));
  EXPECT_FALSE(area.cell_at({-100.0, 1e9}));
}

TEST(SearchArea, StaysInsideItsOutline) {
  const OccupancyGrid map = empty_room(10, 10);
  SearchAreaOptions options = start_at(2, 2);
  options.outline_in_map = {{0, 0}, {5.5, 0}, {5.5, 11}, {0, 11}};

  EXPECT_NEAR(SearchArea(map, options).area_m2(), 50.0, 1.5);
}

TEST(UniformPrior, LeavesOutTheSurroundingsOfTheStart) {
  const OccupancyGrid map = empty_room(10, 4);
  const SearchArea area(map, start_at(1, 1));
  const auto prior = uniform_prior(area, {1, 1}, 3.0);

  EXPECT_NEAR(std::accumulate(prior.begin(), prior.end(), 0.0), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(prior[static_cast<std::size_t>(*area.cell_at({1.2, 1.2}))], 0.0);
}

TEST(Observability, WallsBlockTheView) {
  const OccupancyGrid map = room({"##########", "#...#....#", "#...#....#", "#........#", "##########"});
  const SearchArea area(map, start_at(0.75, 0.75));
  Observability sight(map, area, 4.0);
  const auto& seen = sight.in_sight_of(*area.cell_at({0.75, 1.75}));

  EXPECT_NE(std::ranges::find(seen, *area.cell_at({0.75, 0.75})), seen.end());
  EXPECT_EQ(std::ranges::find(seen, *area.cell_at({4.2, 1.75})), seen.end());
}

TEST(Observability, SeesOnlyInRangeAndInTheFieldOfView) {
  const OccupancyGrid map = empty_room(10, 10);
  const SearchArea area(map, start_at(5, 5));
  Observability sight(map, area, 4.0);
  const View seen = sight.seen_from(camera(), {5.25, 5.25, 0.0});
  const auto sees = [&](double x, double y) { return std::ranges::find(seen, *area.cell_at({x, y})) != seen.end(); };

  EXPECT_TRUE(sees(7.25, 5.25));   // 2 m ahead
  EXPECT_FALSE(sees(5.5, 5.25));   // nearer than the camera sees the floor
  EXPECT_FALSE(sees(9.75, 5.25));  // 4.5 m
  EXPECT_FALSE(sees(5.25, 7.25));  // to the left
  EXPECT_TRUE(sees(7.25, 6.25));   // 26.6 degrees
  EXPECT_FALSE(sees(7.25, 6.75));  // 36.9 degrees: a 3-4-5 triangle
}

TEST(SearchBelief, T13ThePosteriorIsTheJointMassNormalised) {
  SearchBelief belief(std::vector<double>(4, 0.25));
  belief.look(0, {0}, std::log(2.0), 1.0);  // P(not detected) = 0.5
  const auto posterior = belief.posterior();

  EXPECT_NEAR(posterior[0], 1.0 / 7.0, 1e-12);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(posterior[i], 2.0 / 7.0, 1e-12);
}

TEST(SearchBelief, T14SplittingALookAndTheOrderOfAgentsChangeNothing) {
  SearchBelief whole(std::vector<double>(4, 0.25));
  whole.look(0, {0, 1}, 0.5, 1.0);
  whole.look(1, {1, 2}, 1.0, 1.0);
  SearchBelief split(std::vector<double>(4, 0.25));
  for (int i = 0; i < 10; ++i) {
    split.look(1, {1, 2}, 1.0, 0.1);
    split.look(0, {0, 1}, 0.5, 0.1);
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(whole.mass()[i], split.mass()[i], 1e-12);
}

TEST(SearchBelief, T22TheIncrementalBeliefIsTheBeliefFromScratch) {
  const OccupancyGrid map = empty_room(8, 6);
  const SearchArea area(map, start_at(2, 2));
  Observability sight(map, area, 4.0);
  const auto prior = uniform_prior(area, {2, 2}, 0.0);
  SearchBelief belief(prior);
  std::vector<double> exposure(prior.size(), 0.0);
  Rng rng{22};
  for (int i = 0; i < 200; ++i) {
    const View view = sight.seen_from(camera(), {rng.uniform(1, 8), rng.uniform(1, 6), rng.uniform(-3, 3)});
    belief.look(i % 2, view, 1.0, 0.1);
    for (const int cell : view) exposure[static_cast<std::size_t>(cell)] += 0.1;
  }
  for (std::size_t i = 0; i < prior.size(); ++i) {
    EXPECT_NEAR(belief.mass()[i], prior[i] * std::exp(-exposure[i]), 1e-9);
  }
}

TEST(SearchBelief, KnowsWhoSawACellFirst) {
  const OccupancyGrid map = empty_room(2, 2);
  const SearchArea area(map, start_at(1, 1));
  SearchBelief belief(uniform_prior(area, {1, 1}, 0.0));
  belief.look(1, {0, 1}, 1.0, 10.0);
  belief.look(0, {1, 2}, 1.0, 10.0);
  belief.look(0, {3}, 1.0, 0.01);  // a glance does not explore

  const auto shares = explored_shares(area, belief, 2, 0.5);
  EXPECT_NEAR(shares.by_agent[1], 2.0 / area.size(), 1e-9);
  EXPECT_NEAR(shares.by_agent[0], 1.0 / area.size(), 1e-9);
  EXPECT_NEAR(shares.all, 3.0 / area.size(), 1e-9);
}

TEST(SearchForecaster, FindsAtOnceWhatIsSeenOnArrival) {
  SearchForecaster forecaster(1.0, 100.0);
  const View room_a{0};
  const View room_b{1};
  const std::vector<double> mass{0.2, 0.8};
  const AgentViews a_first{{nullptr, &room_a, nullptr, nullptr, nullptr, &room_b}, 1e9};
  const AgentViews b_first{{nullptr, nullptr, nullptr, &room_b, nullptr, nullptr, nullptr, &room_a}, 1e9};

  // T15: rooms 1 m to the left and 3 m to the right, 1 m/s.
  EXPECT_NEAR(forecaster.forecast(mass, {{a_first}}, 10).expected_time_s, 4.2, 1e-6);
  EXPECT_NEAR(forecaster.forecast(mass, {{b_first}}, 10).expected_time_s, 3.8, 1e-6);
  // T16: two agents split.
  const std::vector<AgentViews> split{{{nullptr, &room_a}, 1e9}, {{nullptr, nullptr, nullptr, &room_b}, 1e9}};
  EXPECT_NEAR(forecaster.forecast(mass, split, 10).expected_time_s, 2.6, 1e-6);
}

TEST(SearchForecaster, T22TheExactExpectedTimeIsTheMeanOfManySearches) {
  Rng rng{5};
  constexpr int kCells = 6;
  constexpr int kSteps = 30;
  constexpr double kTail_s = 20.0;
  std::vector<View> views;
  std::vector<AgentViews> agents{{{}, 0.5}, {{}, 1.0}};
  views.reserve(2 * kSteps);
  for (auto& agent : agents) {
    for (int i = 0; i < kSteps; ++i) {
      views.push_back({static_cast<int>(rng.index(kCells))});
      agent.steps.push_back(&views.back());
    }
  }
  const std::vector<double> mass{0.1, 0.2, 0.1, 0.3, 0.2, 0.1};
  SearchForecaster forecaster(0.5, kTail_s);
  const Forecast exact = forecaster.forecast(mass, agents, kSteps);

  double sum = 0.0;
  double sum2 = 0.0;
  constexpr int kSearches = 100'000;
  for (int n = 0; n < kSearches; ++n) {
    int cell = 0;
    for (double u = rng.uniform(); cell < kCells - 1 && u >= mass[static_cast<std::size_t>(cell)]; ++cell) {
      u -= mass[static_cast<std::size_t>(cell)];
    }
    double found_s = kSteps * 0.5 + kTail_s;
    double needed = -std::log(1.0 - rng.uniform());  // exposure at which it is detected
    for (int i = 0; i < kSteps; ++i) {
      double rate = 0.0;
      for (const auto& agent : agents) {
        if (agent.steps[static_cast<std::size_t>(i)]->front() == cell) rate += agent.detection_rate_per_s;
      }
      if (rate * 0.5 >= needed && rate > 0.0) {
        found_s = i * 0.5 + needed / rate;
        break;
      }
      needed -= rate * 0.5;
    }
    sum += found_s;
    sum2 += found_s * found_s;
  }
  const double mean = sum / kSearches;
  const double sigma = std::sqrt((sum2 / kSearches - mean * mean) / kSearches);
  EXPECT_NEAR(exact.expected_time_s, mean, 4.0 * sigma);
}

}  // namespace
}  // namespace tandem
