#include "gateway/server/core/transit.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

TEST(Transit, KnowsWhatWasLongOnItsWay) {
  const auto at = [](double seconds) { return from_stamp_ns(1'000'000'000'000) + from_seconds(seconds); };
  Transit transit;
  EXPECT_NEAR(transit.late_ms(50'000.0, at(0.0)), 0.0, 1e-3);  // the first is the quickest so far
  EXPECT_NEAR(transit.late_ms(51'000.0, at(1.25)), 250.0, 1e-3);
  EXPECT_NEAR(transit.late_ms(52'000.0, at(8.0)), 6000.0, 1e-3);
  EXPECT_NEAR(transit.late_ms(60'000.0, at(9.5)), 0.0, 1e-3);  // quicker: the new measure
  EXPECT_NEAR(transit.late_ms(61'000.0, at(11.0)), 500.0, 1e-3);
}

}  // namespace
}  // namespace tandem::gateway
