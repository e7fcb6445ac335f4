#include "services/tracking/core/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "services/common/random.hpp"

namespace tandem::tracking {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

TEST(Assignment, TakesTheLeastSumNotTheLeastPair) {
  Eigen::MatrixXd costs(2, 2);
  costs << 1.0, 2.0,  //
      2.0, 10.0;
  const auto columns = best_assignment(costs);
  EXPECT_EQ(columns[0], 1);  // 2 + 2 is less than 1 + 10
  EXPECT_EQ(columns[1], 0);
}

TEST(Assignment, LeavesOutForbiddenPairsAndWhatIsTooMany) {
  Eigen::MatrixXd costs(3, 2);
  costs << 1.0, kForbidden,    //
      kForbidden, kForbidden,  //
      0.5, kForbidden;
  const auto columns = best_assignment(costs);
  EXPECT_FALSE(columns[0]);
  EXPECT_FALSE(columns[1]);
  EXPECT_EQ(columns[2], 0);
  EXPECT_TRUE(best_assignment(Eigen::MatrixXd(0, 3)).empty());
  EXPECT_FALSE(best_assignment(Eigen::MatrixXd(1, 0))[0]);
}

TEST(Assignment, PrefersManyPairsToCheapOnes) {
  Eigen::MatrixXd costs(2, 2);
  costs << 0.0, 9.0,  //
      8.0, kForbidden;
  const auto columns = best_assignment(costs);
  EXPECT_EQ(columns[0], 1);
  EXPECT_EQ(columns[1], 0);
}

TEST(Assignment, AgreesWithTryingAllPermutations) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng{seed};
    Eigen::MatrixXd costs(5, 5);
    for (int r = 0; r < 5; ++r) {
      for (int c = 0; c < 5; ++c) costs(r, c) = rng.uniform();
    }
    std::vector<int> permutation(5);
    std::iota(permutation.begin(), permutation.end(), 0);
    double least = kForbidden;
    do {
      double sum = 0.0;
      for (int r = 0; r < 5; ++r) sum += costs(r, permutation[static_cast<std::size_t>(r)]);
      least = std::min(least, sum);
    } while (std::next_permutation(permutation.begin(), permutation.end()));
    const auto columns = best_assignment(costs);
    double sum = 0.0;
    for (int r = 0; r < 5; ++r) sum += costs(r, columns[static_cast<std::size_t>(r)].value());
    EXPECT_NEAR(sum, least, 1e-12) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tandem::tracking
