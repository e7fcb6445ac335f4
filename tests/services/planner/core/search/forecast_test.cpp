#include "services/planner/core/search/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"

namespace tandem {
namespace {

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
