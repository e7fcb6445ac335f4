#include "bench/planning/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tandem::bench {
namespace {

TEST(Statistics, TheGeometricMeanOfAHalfAndTwoIsOne) {
  EXPECT_DOUBLE_EQ(geometric_mean(std::array{0.5, 2.0}), 1.0);
  EXPECT_DOUBLE_EQ(geometric_mean(std::array{2.0, 8.0}), 4.0);
}

TEST(Statistics, AQuantileLiesBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile({10.0, 20.0}, 0.25), 12.5);
}

TEST(Statistics, EqualValuesHaveAnIntervalWithoutWidth) {
  const Interval interval = bootstrapped_geometric_mean(std::array{0.8, 0.8, 0.8}, 1000, Rng{1});
  EXPECT_NEAR(interval.low, 0.8, 1e-12);
  EXPECT_NEAR(interval.high, 0.8, 1e-12);
}

TEST(Statistics, TheBootstrapIntervalHoldsTheTruthAboutNinetyFiveTimesOfAHundred) {
  Rng rng{7};
  int held = 0;
  for (int sample = 0; sample < 200; ++sample) {
    std::vector<double> values;
    for (int i = 0; i < 30; ++i) values.push_back(std::exp(0.1 * rng.normal()));
    const Interval interval = bootstrapped_geometric_mean(values, 500, rng.fork());
    held += interval.low <= 1.0 && 1.0 <= interval.high ? 1 : 0;
  }
  EXPECT_GE(held, 178);
  EXPECT_LE(held, 199);
}

TEST(Statistics, TheBootstrapIntervalIsShiftedTowardsTheLongTail) {
  // One large value among small ones: the interval reaches further up than down.
  std::vector<double> values(19, 1.0);
  values.push_back(4.0);
  const Interval interval = bootstrapped_geometric_mean(values, 5000, Rng{3});
  EXPECT_GT(std::log(interval.high / interval.value), std::log(interval.value / interval.low));
}

TEST(Statistics, WilcoxonCountsTheSubsetsOfRanks) {
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank_p(std::array{-1.0, -2.0, -3.0}), 0.25);                 // 2 of 8
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank_p(std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}), 0.03125);  // 2 of 64
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank_p(std::array{1.0, -2.0, 3.0, 4.0}), 0.375);  // sums 0, 1, 2: 3 of 16, twice
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank_p(std::array{0.0, 0.0}), 1.0);
}

TEST(Statistics, WilcoxonWithTiesGivesTheMiddleRank) {
  // Two of each sign, all equally large: no evidence at all.
  EXPECT_DOUBLE_EQ(wilcoxon_signed_rank_p(std::array{1.0, -1.0, 1.0, -1.0}), 1.0);
}

TEST(Statistics, TheNormalWilcoxonAgreesWithTheExactOne) {
  std::vector<double> differences;
  for (int i = 1; i <= 25; ++i) differences.push_back(i % 3 == 0 ? -i : i);
  const double exact = wilcoxon_signed_rank_p(differences);
  differences[22] = differences[21];  // a tie of two of one sign: now it is computed with the normal distribution
  EXPECT_NEAR(wilcoxon_signed_rank_p(differences), exact, 0.01);
}

TEST(Statistics, AComparisonCountsWinsTiesAndLosses) {
  const PairedComparison comparison =
      compared(std::array{50.0, 100.0, 103.0}, std::array{100.0, 100.5, 100.0}, Rng{1}, 100);
  EXPECT_EQ(comparison.wins, 1);
  EXPECT_EQ(comparison.ties, 1);
  EXPECT_EQ(comparison.losses, 1);
  EXPECT_DOUBLE_EQ(comparison.worst, 1.03);
  EXPECT_NEAR(comparison.ratio.value, std::cbrt(0.5 * 100.0 / 100.5 * 1.03), 1e-12);
}

TEST(Statistics, ASquareGrowsWithExponentTwo) {
  EXPECT_NEAR(growth_exponent(std::array{1.0, 2.0, 10.0}, std::array{3.0, 12.0, 300.0}), 2.0, 1e-12);
}

}  // namespace
}  // namespace tandem::bench
