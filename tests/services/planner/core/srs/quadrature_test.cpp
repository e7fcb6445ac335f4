#include "services/planner/core/srs/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem {
namespace {

TEST(Quadrature, IntegratesWhatIsSmoothWithFifteenLooks) {
  int looks = 0;
  const auto fading = [&](double t) {
    ++looks;
    return std::exp(-t);
  };
  EXPECT_NEAR(integral(fading, 0.0, 2.0, 1e-12), 1.0 - std::exp(-2.0), 1e-14);
  EXPECT_EQ(looks, 15);
}

TEST(Quadrature, FindsAKink) {
  EXPECT_NEAR(integral([](double t) { return std::abs(t - 0.3); }, 0.0, 1.0, 1e-12), 0.5 * (0.09 + 0.49), 1e-11);
}

TEST(Quadrature, GivesNothingForNoInterval) {
  EXPECT_EQ(integral([](double) { return 1.0; }, 1.0, 1.0, 1e-12), 0.0);
}

}  // namespace
}  // namespace tandem
