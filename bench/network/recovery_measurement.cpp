#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/stream.hpp"

namespace tandem::bench {
namespace {

using std::chrono::seconds;

constexpr double kPoseRate_hz = 20.0;
constexpr double kPlanRate_hz = 20.0;
constexpr Duration kPatience = seconds{20};

/// A robot that sends its pose, and a laptop that has heard it.
struct Flowing {
  test::Laboratory lab;
  std::unique_ptr<Side> robot;
  std::unique_ptr<Side> laptop;
  std::unique_ptr<Stream> poses;
  std::unique_ptr<Listener> listener;

  Flowing(const std::string& whose, int run) : lab({"robot", "laptop"}, seed_of(run)) {
    robot = make_side(whose, lab.host("robot"), lab.host("laptop").address());
    laptop = make_side(whose, lab.host("laptop"), lab.host("robot").address());
    poses = pose_stream(*robot, kPoseRate_hz);
    listener = std::make_unique<Listener>(*laptop, info_of(topic::kRobotPose));
    std::ignore = ms_to_next_pose(*listener, seconds{30});
    pause(seconds{2});
  }
};

}  // namespace

Figures first_data(const std::string& whose, const std::string& air, int run) {
  test::Laboratory lab{{"robot", "laptop"}, seed_of(run)};
  lab.set_all(conditions_of(air));
  const auto robot = make_side(whose, lab.host("robot"), lab.host("laptop").address());
  const auto poses = pose_stream(*robot, kPoseRate_hz);
  pause(seconds{5});  // the robot's first announcements are over
  const SteadyClock clock;
  const Time began = clock.now();
  const auto laptop = make_side(whose, lab.host("laptop"), lab.host("robot").address());
  Listener listener{*laptop, info_of(topic::kRobotPose)};
  const double made_ms = to_seconds(clock.now() - began) * 1e3;
  const double waited_ms = ms_to_next_pose(listener, kPatience);
  return {{"ms", waited_ms < kNever ? made_ms + waited_ms : kNever}};
}

Figures after_outage(const std::string& whose, const std::string& air, int run) {
  Flowing flowing{whose, run};
  flowing.lab.set_all({.out = true});
  pause(seconds{30});
  flowing.lab.set_all(conditions_of(air));
  return {{"ms", ms_to_next_pose(*flowing.listener, kPatience)}};
}

Figures after_address_change(const std::string& whose, const std::string& air, int run) {
  Flowing flowing{whose, run};
  const auto plans = plan_stream(*flowing.laptop, kPlanRate_hz);
  Listener plans_in{*flowing.robot, info_of(topic::kTeamPlan)};
  if (!holds_within(seconds{30}, [&] { return !plans_in.arrivals->take().empty(); })) return {};
  flowing.lab.set_all(conditions_of(air));
  flowing.lab.host("robot").change_address("10.66.0.22");
  const Time changed = SteadyClock{}.now();
  Figures figures{{"to_laptop_ms", kNever}, {"to_robot_ms", kNever}};
  holds_within(kPatience, [&] {
    auto& to_laptop = figures["to_laptop_ms"];
    auto& to_robot = figures["to_robot_ms"];
    to_laptop = std::min(to_laptop, ms_to_first<msg::RobotPosePubSubType>(*flowing.listener, changed));
    to_robot = std::min(to_robot, ms_to_first<msg::TeamPlanPubSubType>(plans_in, changed));
    return std::max(to_laptop, to_robot) < kNever;
  });
  return figures;
}

}  // namespace tandem::bench
