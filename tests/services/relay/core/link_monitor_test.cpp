#include "services/relay/core/link_monitor.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Two hosts whose clocks differ by `offset`, exchanging heartbeats each 100 ms over a link with `delay` each way.
struct Exchange {
  LinkMonitor robot{"robot1", milliseconds{1500}};
  LinkMonitor laptop{"laptop1", milliseconds{1500}};
  Duration offset;  ///< the laptop's clock minus the robot's
  Duration delay;
  Time now{seconds{1000}};  ///< the robot's clock
  bool to_robot = true;
  bool to_laptop = true;

  void run(int beats, int lose_every = 0) {
    for (int i = 1; i <= beats; ++i) {
      const auto from_robot = robot.next_heartbeat(now);
      const auto from_laptop = laptop.next_heartbeat(now + offset);
      const bool lost = lose_every > 0 && i % lose_every == 0;
      if (to_laptop) laptop.heard(from_robot, now + offset + delay);
      if (to_robot && !lost) robot.heard(from_laptop, now + delay);
      now += milliseconds{100};
    }
  }
};

TEST(LinkMonitor, MeasuresRoundTripAndClockOffset) {
  Exchange link{.offset = seconds{5}, .delay = milliseconds{20}};
  link.run(20);

  EXPECT_TRUE(link.robot.state(link.now).up);
  EXPECT_EQ(link.robot.state(link.now).peer, "laptop1");
  EXPECT_NEAR(link.robot.state(link.now).round_trip_s, 0.040, 1e-9);
  EXPECT_NEAR(link.robot.state(link.now).clock_offset_s, 5.0, 1e-9);
  EXPECT_NEAR(link.laptop.state(link.now + link.offset).clock_offset_s, -5.0, 1e-9);
  EXPECT_FALSE(link.robot.state(link.now).one_way);
}

TEST(LinkMonitor, IsLostWhenNoHeartbeatCameForTheTimeOut) {
  Exchange link{.offset = {}, .delay = milliseconds{1}};
  EXPECT_FALSE(link.robot.state(link.now).up);
  link.run(5);
  const Time last = link.now - milliseconds{100} + link.delay;

  EXPECT_TRUE(link.robot.state(last + milliseconds{1500}).up);
  EXPECT_FALSE(link.robot.state(last + milliseconds{1501}).up);
}

TEST(LinkMonitor, NamesAnOutageOfOneDirection) {
  Exchange link{.offset = {}, .delay = milliseconds{1}};
  link.run(20);
  link.to_laptop = false;
  link.run(20);

  EXPECT_TRUE(link.robot.state(link.now).up);
  EXPECT_TRUE(link.robot.state(link.now).one_way);
  EXPECT_FALSE(link.laptop.state(link.now).up);
}

TEST(LinkMonitor, CountsWhatWasLost) {
  Exchange link{.offset = {}, .delay = milliseconds{1}};
  link.run(49, 5);
  EXPECT_NEAR(link.robot.state(link.now).loss, 0.2, 0.02);
}

TEST(LinkMonitor, AcceptsAPeerThatStartedAgain) {
  Exchange link{.offset = {}, .delay = milliseconds{1}};
  link.run(20);
  link.laptop = LinkMonitor{"laptop1", milliseconds{1500}};
  link.run(5);
  EXPECT_TRUE(link.robot.state(link.now + seconds{1}).up);
  EXPECT_NEAR(link.robot.state(link.now).loss, 0.0, 1e-9);
}

TEST(LinkMonitor, DoesNotHearItself) {
  LinkMonitor robot{"robot1", seconds{1}};
  robot.heard(robot.next_heartbeat(Time{}), Time{});
  EXPECT_FALSE(robot.state(Time{}).up);
}

}  // namespace
}  // namespace tandem
