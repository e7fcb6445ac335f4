#include "services/planner/core/srs/safe_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem {
namespace {

std::vector<double> roots_of(const auto& function, double change) {
  std::vector<double> roots;
  append_safe_roots(function, change, 1e-4, 1e-9, roots);
  return roots;
}

TEST(SafeRoots, FindsEveryChangeOfSign) {
  const auto roots = roots_of([](double t) { return std::cos(3.0 * std::numbers::pi * t); }, 3.0 * std::numbers::pi);
  ASSERT_EQ(roots.size(), 3u);
  EXPECT_NEAR(roots[0], 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(roots[1], 0.5, 1e-12);
  EXPECT_NEAR(roots[2], 5.0 / 6.0, 1e-12);
}

TEST(SafeRoots, DoesNotLookWhereItCannotBe) {
  int looks = 0;
  EXPECT_TRUE(roots_of(
                  [&](double t) {
                    ++looks;
                    return 5.0 + t;
                  },
                  1.0)
                  .empty());
  EXPECT_EQ(looks, 2);
}

TEST(SafeRoots, HasNoneWhereTheFunctionStaysZero) {
  EXPECT_TRUE(roots_of([](double) { return 1e-12; }, 10.0).empty());
}

}  // namespace
}  // namespace tandem
