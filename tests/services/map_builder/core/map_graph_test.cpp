#include "services/map_builder/core/map_graph.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(MapGraph, TrustsTheWheelsLessTheFurtherTheyWent) {
  MapBuilderConfig config;
  config.wheels.forward_per_m = 0.1;
  config.wheels.drift_m = 0.0;
  EXPECT_NEAR(information_of_wheels({1.0, 0.0, 0.0}, config)(0, 0), 100.0, 1e-9);  // 0.1 m
  EXPECT_NEAR(information_of_wheels({2.0, 0.0, 0.0}, config)(0, 0), 25.0, 1e-9);   // 0.2 m
}

TEST(MapGraph, LaysScansAsTheConfigSays) {
  MapBuilderConfig config;
  config.last_reach_m = 0.123;
  EXPECT_EQ(registration_options(config).last_reach_m, 0.123);
}

}  // namespace
}  // namespace tandem
