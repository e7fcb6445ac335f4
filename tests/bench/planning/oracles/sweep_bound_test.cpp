#include "bench/planning/oracles/sweep_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem::bench {
namespace {

PlanningInstance hall(double length_m, double width_m) {
  PlanningInstance instance;
  instance.plan = {length_m, width_m, 0.1, {}};
  instance.area.cell_size_m = 0.5;
  instance.area.start_in_map = {1.0, 0.5 * width_m};
  Searcher walker{.id = "walker", .speed_mps = 1.0, .view_max_m = 2.0};
  walker.detection_rate_per_s = std::numeric_limits<double>::infinity();
  instance.searchers = {walker};
  instance.starts = {{1.0, 0.5 * width_m, 0.0}};
  instance.horizon_s = 500.0;
  return instance;
}

double bound_of(const PlanningInstance& instance) {
  const auto layers = layers_of(instance);
  const SearchArea area(layers.front(), instance.area);
  const std::vector<double> prior = uniform_prior(area, instance.starts.front().position(), 0.0);
  return sweep_lower_bound_s(instance, area, layers, prior);
}

TEST(SweepBound, InAWideHallIsTheTimeOfAPerfectSweep) {
  // Seen at once: a disc of r = 2 m + sqrt(2) * 0.5 m; then 2 r per second. The mean time of a uniform sweep of A:
  // (A - pi r^2)^2 / (2 r) / (2 A).
  const double r = 2.0 + std::numbers::sqrt2 * 0.5;
  const double area_m2 = 1600.0;
  const double swept_m2 = area_m2 - std::numbers::pi * r * r;
  const double sweep_s = swept_m2 * swept_m2 / (2.0 * r) / (2.0 * area_m2);
  EXPECT_NEAR(bound_of(hall(40.0, 40.0)), sweep_s, 0.02 * sweep_s);
}

TEST(SweepBound, InACorridorIsTheTimeToReachWhatIsFar) {
  // From 1 m to the end at 101 m nobody sees further than r ahead: the mean of (x - 1 - r) over x in [1 + r, 101],
  // less what the eight-neighbour distance may be too long.
  const double r = 2.0 + std::numbers::sqrt2 * 0.5;
  const double far_m = 100.0 - r;
  EXPECT_NEAR(bound_of(hall(101.0, 2.0)), far_m * far_m / 2.0 / 101.0, 1.0);
}

TEST(SweepBound, HalvesWithTwiceTheSearchersInAWideHall) {
  PlanningInstance two = hall(80.0, 80.0);
  const double alone_s = bound_of(two);
  two.searchers.push_back(two.searchers.front());
  two.starts.push_back(two.starts.front());
  EXPECT_NEAR(bound_of(two), 0.5 * alone_s, 0.02 * alone_s);
}

TEST(SweepBound, ADetourCounts) {
  // A wall across the hall with a door at its far end.
  PlanningInstance instance = hall(20.0, 20.0);
  const OccupancyGrid open = layers_of(instance).front();
  instance.plan.boxes = {{{10.0, 0.0}, {10.2, 18.0}}};
  const OccupancyGrid walled = layers_of(instance).front();
  const Eigen::Vector2d start{1.0, 1.0};
  const CellIndex behind = open.cell_at({11.0, 1.0});
  EXPECT_NEAR(least_distances_m(open, start)[open.offset(behind)], 10.0 / 1.0824 - 0.2, 0.2);
  EXPECT_GT(least_distances_m(walled, start)[walled.offset(behind)], 30.0);
}

}  // namespace
}  // namespace tandem::bench
