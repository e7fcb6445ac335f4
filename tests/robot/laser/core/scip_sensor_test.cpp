#include "robot/laser/core/scip_sensor.hpp"

#include <gtest/gtest.h>

#include "services/common/angle.hpp"

namespace tandem::scip {
namespace {

TEST(ScipSensor, LooksAheadAtItsFrontStepAndTurnsCounterClockwise) {
  const SensorParameters sensor = utm_30lx();
  EXPECT_DOUBLE_EQ(angle_of_step(sensor, 540), 0.0);
  EXPECT_DOUBLE_EQ(angle_of_step(sensor, 0), from_degrees(-135.0));
  EXPECT_DOUBLE_EQ(angle_of_step(sensor, 1080), from_degrees(135.0));
  EXPECT_DOUBLE_EQ(turn_period_s(sensor), 0.025);
}

TEST(ScipSensor, SaysItsParametersAndIsUnderstood) {
  EXPECT_EQ(parse_parameters(parameter_lines(urg_04lx())), urg_04lx());
  EXPECT_EQ(parse_parameters(parameter_lines(utm_30lx())), utm_30lx());
  EXPECT_EQ(parse_parameters(parameter_lines(ust_10lx()))->range_max_mm, 30'000);
  EXPECT_EQ(parse_parameters(parameter_lines(ust_20lx()))->range_max_mm, 60'000);
  EXPECT_EQ(parameter_lines(utm_30lx())[3], "ARES:1440");
}

TEST(ScipSensor, IsNotUnderstoodWithAKeyMissingOrSenseless) {
  auto lines = parameter_lines(utm_30lx());
  lines.pop_back();
  EXPECT_FALSE(parse_parameters(lines));
  EXPECT_FALSE(parse_parameters({}));

  SensorParameters backwards = utm_30lx();
  backwards.last_step = 0;
  EXPECT_FALSE(parse_parameters(parameter_lines(backwards)));
  lines = parameter_lines(utm_30lx());
  lines[3] = "ARES:many";
  EXPECT_FALSE(parse_parameters(lines));
}

}  // namespace
}  // namespace tandem::scip
