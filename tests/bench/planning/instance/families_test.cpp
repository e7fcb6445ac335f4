#include "bench/planning/instance/families.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem::bench {
namespace {

TEST(Families, EqualSeedsGiveEqualInstances) {
  const PlanningInstance once = instance_of("S1u", 5);
  const PlanningInstance again = instance_of("S1u", 5);
  EXPECT_EQ(layers_of(once), layers_of(again));
  EXPECT_EQ(once.starts, again.starts);
  EXPECT_NE(layers_of(instance_of("S1u", 6)), layers_of(once));
}

TEST(Families, VariantsShareMapsAndStarts) {
  const PlanningInstance uniform = instance_of("S1u", 9);
  const PlanningInstance excluded = instance_of("S1x", 9);
  EXPECT_EQ(layers_of(uniform), layers_of(excluded));
  EXPECT_EQ(uniform.starts, excluded.starts);
  EXPECT_EQ(instance_of("S1u4", 9).starts.front(), uniform.starts.front());
}

TEST(Families, EverybodyStartsWhereTheyCanStand) {
  for (const auto& family : {"S0m", "S1u4", "S4", "S6", "S1brl"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const PlanningInstance instance = instance_of(family, seed);
      const auto layers = layers_of(instance);
      ASSERT_EQ(instance.starts.size(), instance.searchers.size());
      for (std::size_t m = 0; m < instance.starts.size(); ++m) {
        const DistanceField clearance(layers.front(), 2.0, Obstacles::OccupiedOrUnknown);
        EXPECT_GE(clearance.nearest(instance.starts[m].position()), instance.searchers[m].radius_m)
            << family << " seed " << seed << " searcher " << m;
      }
    }
  }
}

TEST(Families, NearlyAllFloorCanBeWalkedTo) {
  for (const auto& family : {"S1u", "S2r2", "S2p2"}) {
    const PlanningInstance instance = instance_of(family, 1);
    EXPECT_GE(reachable_share(layers_of(instance).front(), instance.starts.front().position(), 0.4), 0.97) << family;
  }
}

TEST(Families, AnOfficeFloorHasTenThousandSquareMetres) {
  const OccupancyGrid map = layers_of(instance_of("S2r2", 1)).front();
  double free_m2 = 0.0;
  for (const CellState cell : map.cells())
    free_m2 += cell == CellState::Free ? map.resolution_m() * map.resolution_m() : 0;
  EXPECT_GT(free_m2, 8500.0);
  EXPECT_LE(free_m2, 10000.0);
}

TEST(Families, ADroneFliesAboveLowWalls) {
  const PlanningInstance instance = instance_of("S4", 2);
  ASSERT_EQ(layers_of(instance).size(), 2U);
  EXPECT_EQ(instance.searchers.back().layer, 1);
  EXPECT_NE(layers_of(instance)[0], layers_of(instance)[1]);
}

TEST(Families, AnUnknownFamilyIsRefusedWithTheNamesThereAre) {
  try {
    (void)instance_of("S99", 1);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("S1u"), std::string::npos);
  }
}

}  // namespace
}  // namespace tandem::bench
