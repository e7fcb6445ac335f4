#include "services/planner/core/search/search_belief.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

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

/// What was done to a belief, one thing after the other, and what follows from all of it together.
class History {
 public:
  explicit History(std::vector<double> prior)
      : prior_(std::move(prior)), weight_(prior_.size(), 1.0), exposure_(prior_.size(), 0.0) {}

  void look(const View& cells, double exposure) {
    for (const int cell : cells) exposure_[static_cast<std::size_t>(cell)] += exposure;
  }
  void weigh(const View& cells, double weight) {
    for (const int cell : cells) weight_[static_cast<std::size_t>(cell)] = weight;
  }
  void claim(const View& cells, double exposure) {
    for (const int cell : cells) {
      exposure_[static_cast<std::size_t>(cell)] = std::max(exposure_[static_cast<std::size_t>(cell)], exposure);
    }
  }
  void look_again(const View& cells) {
    for (const int cell : cells) {
      exposure_[static_cast<std::size_t>(cell)] = 0.0;
      weight_[static_cast<std::size_t>(cell)] = std::max(weight_[static_cast<std::size_t>(cell)], 1.0);
    }
  }
  [[nodiscard]] std::vector<double> mass() const {
    const double sum = std::inner_product(prior_.begin(), prior_.end(), weight_.begin(), 0.0);
    std::vector<double> mass;
    for (std::size_t i = 0; i < prior_.size(); ++i) {
      mass.push_back(prior_[i] * weight_[i] / sum * std::exp(-exposure_[i]));
    }
    return mass;
  }

 private:
  std::vector<double> prior_;
  std::vector<double> weight_;
  std::vector<double> exposure_;
};

TEST(SearchBelief, T22ItIsTheBeliefFromScratchWhoeverLooksHoweverWellAndWhateverIsSaidMeanwhile) {
  const OccupancyGrid map = empty_room(8, 6);
  const SearchArea area(map, start_at(2, 2));
  Observability sight(map, area, 4.0);
  const auto prior = uniform_prior(area, {2, 2}, 0.0);
  constexpr std::array kRates_per_s{0.05, 0.5, 1.0, 5.0, std::numeric_limits<double>::infinity()};
  constexpr std::array kWeights{0.1, 0.25, 4.0, 10.0};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng{seed};
    SearchBelief belief(prior);
    History history(prior);
    for (int i = 0; i < 200; ++i) {
      const View cells = sight.seen_from(test_robot(), {rng.uniform(1, 8), rng.uniform(1, 6), rng.uniform(-3, 3)});
      const double weight = kWeights[rng.index(kWeights.size())];
      const double rate_per_s = kRates_per_s[rng.index(kRates_per_s.size())];
      switch (rng.index(10)) {
        case 0:
          belief.weigh(cells, weight);
          history.weigh(cells, weight);
          break;
        case 1:
          belief.claim_look(1, cells, 0.7);
          history.claim(cells, 0.7);
          break;
        case 2:
          belief.look_again(cells);
          history.look_again(cells);
          break;
        default:
          belief.look(i % 2, cells, rate_per_s, 0.1);
          history.look(cells, 0.1 * rate_per_s);
      }
      const auto from_scratch = history.mass();
      for (std::size_t c = 0; c < prior.size(); ++c) {
        ASSERT_NEAR(belief.mass()[c], from_scratch[c], 1e-9) << "seed " << seed << ", step " << i;
      }
    }
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
