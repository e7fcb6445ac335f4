#include "services/experiment/core/report/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem::experiment {
namespace {

TEST(Statistics, MeanDeviationAndMedianByHand) {
  const std::vector<double> values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  EXPECT_DOUBLE_EQ(mean_of(values), 5.0);
  EXPECT_DOUBLE_EQ(deviation_of(values), std::sqrt(32.0 / 7.0));
  EXPECT_DOUBLE_EQ(median_of(values), 4.5);
  EXPECT_DOUBLE_EQ(median_of(std::vector{3.0, 1.0, 2.0}), 2.0);
  EXPECT_DOUBLE_EQ(deviation_of(std::vector{3.0}), 0.0);
}

// The textbook example of Wikipedia, "One-way analysis of variance": F = 9.3 with 2 and 15 degrees of freedom.
TEST(Anova, OfATextbookExample) {
  const std::vector<std::vector<double>> groups{{6, 8, 4, 5, 3, 4}, {8, 12, 9, 11, 6, 8}, {13, 9, 11, 8, 7, 12}};
  const auto result = anova(groups);
  EXPECT_EQ(result.between, 2);
  EXPECT_EQ(result.within, 15);
  EXPECT_NEAR(result.f, 42.0 / (68.0 / 15.0), 1e-12);
  EXPECT_NEAR(result.p, 0.0024, 0.00005);
  EXPECT_NEAR(result.eta_squared, 84.0 / 152.0, 1e-12);
}

// With two groups F is the square of Student's t, and p that of the t test: t = 3/sqrt(2.5 * 2/5) = 3, 8 degrees of
// freedom, p = 0.01707 (two-sided, from tables).
TEST(Anova, OfTwoGroupsIsTheTTest) {
  const std::vector<std::vector<double>> groups{{1, 2, 3, 4, 5}, {4, 5, 6, 7, 8}};
  const auto result = anova(groups);
  EXPECT_NEAR(result.f, 9.0, 1e-12);
  EXPECT_NEAR(result.p, 0.01707, 0.00001);
}

TEST(Anova, SaysNothingWhereNothingCanBeSaid) {
  EXPECT_DOUBLE_EQ(anova(std::vector<std::vector<double>>{{1, 2, 3}}).p, 1.0);
  EXPECT_DOUBLE_EQ(anova(std::vector<std::vector<double>>{{1, 2, 3}, {}}).p, 1.0);
  EXPECT_DOUBLE_EQ(anova(std::vector<std::vector<double>>{{1}, {2}}).p, 1.0);
  EXPECT_DOUBLE_EQ(anova(std::vector<std::vector<double>>{{1, 2}, {2, 1}}).p, 1.0);
  EXPECT_DOUBLE_EQ(anova(std::vector<std::vector<double>>{{1, 1}, {2, 2}}).p, 0.0);
}

// Of the 8 ways of signing 1, 2, 3 the sums are +-6, +-4, +-2, 0, 0: two are as far from 0 as 6.
TEST(PairedPermutation, IsExactForFewPairs) {
  EXPECT_DOUBLE_EQ(paired_permutation_p(std::vector{1.0, 2.0, 3.0}), 0.25);
  EXPECT_DOUBLE_EQ(paired_permutation_p(std::vector{1.0, 2.0, -3.0}), 1.0);
  EXPECT_DOUBLE_EQ(paired_permutation_p({}), 1.0);
  EXPECT_DOUBLE_EQ(paired_permutation_p(std::vector(10, 0.1)), 2.0 / 1024.0);
}

TEST(PairedPermutation, OfManyPairsIsNearTheExactOne) {
  std::vector<double> differences;  // 24 alike: exactly 2 of 2^24
  for (int i = 0; i < 24; ++i) differences.push_back(1.0);
  EXPECT_LT(paired_permutation_p(differences), 1e-4);
  for (std::size_t i = 0; i < differences.size(); i += 2) differences[i] = -1.0;
  EXPECT_GT(paired_permutation_p(differences), 0.99);
}

// {1, 2, 3} against {4, 5, 6}: of 20 divisions two are as far apart: p = 0.1.
TEST(Permutation, OfTwoGroupsIsNearTheExactOne) {
  EXPECT_NEAR(permutation_p(std::vector{1.0, 2.0, 3.0}, std::vector{4.0, 5.0, 6.0}), 0.1, 0.005);
  EXPECT_NEAR(permutation_p(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}), 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(permutation_p({}, std::vector{1.0}), 1.0);
}

// Means 3 and 6, pooled deviation sqrt(2.5), correction 1 - 3/31.
TEST(HedgesG, ByHandAndWithinItsInterval) {
  const auto effect = hedges_g(std::vector{1.0, 2.0, 3.0, 4.0, 5.0}, std::vector{4.0, 5.0, 6.0, 7.0, 8.0});
  EXPECT_NEAR(effect.g, 3.0 / std::sqrt(2.5) * (1.0 - 3.0 / 31.0), 1e-12);
  EXPECT_LT(effect.low, effect.g);
  EXPECT_GT(effect.high, effect.g);
  EXPECT_DOUBLE_EQ(hedges_g(std::vector{1.0}, std::vector{2.0, 3.0}).g, 0.0);
}

TEST(Holm, ByHand) {
  const auto adjusted = holm_adjusted(std::vector{0.04, 0.01, 0.03});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.06);  // not below that of 0.03
  EXPECT_DOUBLE_EQ(adjusted[1], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
  EXPECT_DOUBLE_EQ(holm_adjusted(std::vector{0.6, 0.7})[0], 1.0);
}

}  // namespace
}  // namespace tandem::experiment
