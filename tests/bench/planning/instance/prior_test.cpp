#include "bench/planning/instance/prior.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tandem::bench {
namespace {

class PriorOfAHall : public testing::Test {
 protected:
  OccupancyGrid map_ = drawn({10.0, 4.0, 0.1, {}}, 0.0);
  SearchArea area_{map_, {1.0, 0.25, {1.0, 2.0}, {}}};  // 40 cells of 1 m2
  std::vector<bool> all_ = std::vector<bool>(40, true);

  [[nodiscard]] double at(const std::vector<double>& prior, double x, double y) const {
    return prior[static_cast<std::size_t>(area_.cell_at({x, y}).value())];
  }
};

TEST_F(PriorOfAHall, IsUniformIfNothingElseIsSaid) {
  const auto prior = prior_of({}, area_, {1.0, 2.0}, all_);
  ASSERT_EQ(prior.size(), 40U);
  EXPECT_NEAR(at(prior, 0.5, 0.5), 1.0 / 40.0, 1e-12);
}

TEST_F(PriorOfAHall, LeavesOutWhatIsExcludedOrUnseen) {
  all_[static_cast<std::size_t>(area_.cell_at({9.5, 3.5}).value())] = false;
  const auto prior = prior_of({1.0, {}, 5.0}, area_, {0.0, 2.0}, all_);
  EXPECT_DOUBLE_EQ(at(prior, 1.5, 1.5), 0.0);
  EXPECT_DOUBLE_EQ(at(prior, 9.5, 3.5), 0.0);
  EXPECT_NEAR(std::accumulate(prior.begin(), prior.end(), 0.0), 1.0, 1e-12);
}

TEST_F(PriorOfAHall, AHillHasTheShareOfItsWeight) {
  const auto prior = prior_of({0.2, {{{9.0, 2.0}, 0.2, 0.8}}, 0.0}, area_, {1.0, 2.0}, all_);
  // Far from the hill only the uniform part is left: 0.2 over 40 cells.
  EXPECT_NEAR(at(prior, 0.5, 0.5), 0.005, 1e-9);
  EXPECT_NEAR(std::accumulate(prior.begin(), prior.end(), 0.0), 1.0, 1e-12);
}

}  // namespace
}  // namespace tandem::bench
