// The last promise of the gate: whatever is commanded, the hull never enters a keep-out zone of the map. The whole way
// from command to wheels, with ramps, quantised speeds and slip, in virtual time.
#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "tests/robot/pioneer/simulated_base.hpp"

namespace tandem {
namespace {

using safety::HardZone;

/// A room of keep-out zones around the start, 8 m by 6 m, with a triangle and a hollow in it; and a slow strip.
std::vector<HardZone> maze() {
  const auto box = [](double x0, double y0, double x1, double y1, double speed = 0.0) {
    return HardZone{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, speed};
  };
  return {box(0.0, 0.0, 30.0, 2.0),
          box(0.0, 8.0, 30.0, 11.0),
          box(0.0, 0.0, 2.0, 11.0),
          box(11.0, 0.0, 13.0, 11.0),
          {{{6.0, 4.0}, {7.5, 4.6}, {6.6, 6.0}}, 0.0},
          {{{8.5, 6.2}, {10.0, 6.2}, {10.0, 8.0}, {9.7, 8.0}, {9.7, 6.5}, {8.5, 6.5}}, 0.0},
          box(3.0, 2.0, 4.5, 4.0, 0.15)};
}

bool is_in(const std::vector<HardZone>& zones, const Pose2& map_from_base, bool keep_out) {
  return std::any_of(zones.begin(), zones.end(), [&](const HardZone& zone) {
    return zone.is_keep_out() == keep_out && safety::overlaps(safety::Hull{}, map_from_base, zone);
  });
}

TEST(HardZones, AMillionRandomCommandsNeverPutTheHullIntoAKeepOutZone) {
  constexpr std::uint64_t kSeed = 11;
  constexpr int kEpisodes = 100;
  constexpr int kCommands = 10'000;
  Rng rng{kSeed};
  double way_m = 0.0;
  int at_a_zone = 0;
  double fastest_in_slow_mps = 0.0;
  const auto zones = maze();
  for (int episode = 0; episode < kEpisodes; ++episode) {
    SimulatedBase::Setup setup{.zones = zones, .start = {3.5, 6.0, rng.uniform(-3.1, 3.1)}, .seed = rng.bits()};
    SimulatedBase robot{setup};
    robot.commanding = false;
    robot.run(6.0);
    for (int i = 0; i < kCommands; ++i) {
      if (i % 20 == 0) robot.command = {rng.uniform(-0.5, 0.9), rng.uniform(-1.5, 1.5)};    // held for a second
      if (i % 400 < 100) robot.command = {rng.uniform(-0.5, 0.9), rng.uniform(-1.5, 1.5)};  // or a new one each time
      robot.kind = episode % 2 == 0 ? safety::CommanderKind::Program : safety::CommanderKind::Operator;
      robot.commanding = true;
      robot.step();
      robot.step();
      ASSERT_FALSE(is_in(zones, robot.map_from_base(), true))
          << "seed " << kSeed << " episode " << episode << " command " << i << " at (" << robot.map_from_base().x
          << ", " << robot.map_from_base().y << ", " << robot.map_from_base().heading << ")";
      if (is_in(zones, robot.map_from_base(), false)) {
        fastest_in_slow_mps = std::max(fastest_in_slow_mps, std::abs(robot.forward_mps()));
      }
      at_a_zone += robot.holds(safety::Cause::KeepOutAhead) ? 1 : 0;
    }
    way_m += robot.way_m;
  }
  EXPECT_LE(fastest_in_slow_mps, 0.15 + 0.02);
  EXPECT_GT(fastest_in_slow_mps, 0.1) << "it must have been in the slow zone";
  EXPECT_GT(way_m, 1'000.0) << "it must have driven";
  EXPECT_GT(at_a_zone, 10'000) << "it must have wanted to get in";
}

}  // namespace
}  // namespace tandem
