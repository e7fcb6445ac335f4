#include "services/common/random.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tandem {
namespace {

TEST(Random, EqualSeedsGiveEqualNumbersAndOthersOthers) {
  Rng one{3};
  Rng same{3};
  Rng other{4};
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto bits = one.bits();
    EXPECT_EQ(bits, same.bits());
    equal += bits == other.bits() ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

TEST(Random, TheNumbersOfASeedStayTheSameForEver) {
  // SplitMix64 of seed 0 begins with e220a8397b1dcdaf, 6e789e6aa1b965f4; xoshiro256** gives rotl(s1 * 5, 7) * 9 first.
  const std::uint64_t product = 0x6e789e6aa1b965f4ULL * 5;
  Rng rng{0};
  EXPECT_EQ(rng.bits(), ((product << 7) | (product >> 57)) * 9);
}

TEST(Random, UniformNumbersLieInTheirIntervalAndFillIt) {
  Rng rng{5};
  double sum = 0.0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    const double value = rng.uniform(2.0, 4.0);
    ASSERT_GE(value, 2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
  }
  EXPECT_NEAR(sum / kCount, 3.0, 0.01);  // standard error 0.0018
}

TEST(Random, AnIndexIsEachOneAboutEquallyOften) {
  Rng rng{6};
  std::array<int, 5> hits{};
  for (int i = 0; i < 50'000; ++i) ++hits.at(rng.index(hits.size()));
  for (const int count : hits) EXPECT_NEAR(count, 10'000, 450);  // five standard deviations
}

TEST(Random, NormalNumbersHaveTheirMeanAndDeviation) {
  Rng rng{7};
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    const double value = rng.normal(1.0, 2.0);
    sum += value;
    squares += (value - 1.0) * (value - 1.0);
  }
  EXPECT_NEAR(sum / kCount, 1.0, 0.03);
  EXPECT_NEAR(squares / kCount, 4.0, 0.1);
}

TEST(Random, WhatAForkDrawsChangesNothingForItsParent) {
  Rng drawn{8};
  Rng untouched{8};
  Rng fork = drawn.fork();
  (void)untouched.fork();
  for (int i = 0; i < 10; ++i) (void)fork.bits();
  EXPECT_EQ(drawn.bits(), untouched.bits());
}

}  // namespace
}  // namespace tandem
