#include "services/planner/core/search/searcher.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace tandem {
namespace {

TEST(Searcher, SeesAllAroundFromAWholeTurnOn) {
  Searcher searcher;
  EXPECT_TRUE(searcher.sees_all_around());
  searcher.field_of_view_rad = std::numbers::pi;
  EXPECT_FALSE(searcher.sees_all_around());
}

TEST(Searcher, WhoDiffersInNameOrBatteryAloneHasTheSameCapability) {
  Searcher other;
  other.id = "another";
  other.endurance_s = 600.0;
  EXPECT_TRUE(same_capability(Searcher{}, other));
}

TEST(Searcher, WhoMovesOrSeesOtherwiseHasAnotherCapability) {
  const std::vector<std::function<void(Searcher&)>> changes{
      [](Searcher& one) { one.speed_mps *= 2.0; },
      [](Searcher& one) { one.turn_rate_radps *= 2.0; },
      [](Searcher& one) { one.radius_m *= 2.0; },
      [](Searcher& one) { one.preferred_clearance_m *= 2.0; },
      [](Searcher& one) { one.view_min_m += 0.5; },
      [](Searcher& one) { one.view_max_m *= 2.0; },
      [](Searcher& one) { one.field_of_view_rad = 1.0; },
      [](Searcher& one) { one.detection_rate_per_s *= 2.0; },
      [](Searcher& one) { one.layer = 1; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Searcher other;
    changes[i](other);
    EXPECT_FALSE(same_capability(Searcher{}, other)) << "change " << i;
    EXPECT_FALSE(same_capability(other, Searcher{})) << "change " << i;
  }
}

}  // namespace
}  // namespace tandem
