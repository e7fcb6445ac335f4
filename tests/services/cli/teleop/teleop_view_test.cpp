#include "services/cli/teleop/teleop_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem::cli {
namespace {

bool has(const TeleopView& view, const std::string& line) {
  const auto lines = lines_of(view);
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TeleopView driving() {
  TeleopView view;
  view.wanted = {0.3, 0.0, -0.25};
  view.measured = Twist2{0.28, 0.0, -0.2};
  view.base = TeleopView::Base{.connected = true,
                               .motors_enabled = true,
                               .battery_v = 12.6,
                               .speed_limit_mps = 0.5,
                               .stopped_by = {},
                               .latched = false,
                               .resume_in_s = 0.0,
                               .model = "p2at"};
  return view;
}

TEST(TeleopView, ShowsWhatIsAskedWhatIsDrivenAndTheBattery) {
  EXPECT_TRUE(has(driving(), "asked     0.30 m/s  -0.25 rad/s"));
  EXPECT_TRUE(has(driving(), "driven    0.28 m/s  -0.20 rad/s"));
  EXPECT_TRUE(has(driving(), "base     p2at, motors on, battery 12.6 V, limit 0.50 m/s"));
  EXPECT_TRUE(has(driving(), "gate     free to move"));
}

TEST(TeleopView, SaysWhyTheRobotStandsAndWhatItWaitsFor) {
  TeleopView view = driving();
  view.base->stopped_by = {"bumper", "no scan"};
  view.base->latched = true;
  EXPECT_TRUE(has(view, "gate     stopped: bumper, no scan"));
  view.base->stopped_by.clear();
  EXPECT_TRUE(has(view, "gate     stopped: hold r for a second to resume"));
  view.base->latched = false;
  view.base->resume_in_s = 2.0;
  EXPECT_TRUE(has(view, "gate     stopped: goes on in 2 s"));
  view.resume_answer = "the bumper is still pressed";
  EXPECT_TRUE(has(view, "resume   refused: the bumper is still pressed"));
}

TEST(TeleopView, SaysWhatIsMissing) {
  TeleopView view = driving();
  view.base->connected = false;
  view.measured.reset();
  EXPECT_TRUE(has(view, "base     the robot's controller does not answer"));
  EXPECT_TRUE(has(view, "driven   not known: no odometry comes"));
  view.base.reset();
  EXPECT_TRUE(has(view, "base     its service is silent"));
  view.gamepad = "pad";
  EXPECT_TRUE(has(view, "gamepad  pad"));
}

}  // namespace
}  // namespace tandem::cli
