#include "services/planner/core/search/search_belief.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

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
    const View view = sight.seen_from(test_robot(), {rng.uniform(1, 8), rng.uniform(1, 6), rng.uniform(-3, 3)});
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

}  // namespace
}  // namespace tandem
