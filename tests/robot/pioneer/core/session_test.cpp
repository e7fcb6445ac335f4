#include "robot/pioneer/core/session.hpp"

#include <gtest/gtest.h>

#include "services/common/angle.hpp"
#include "services/common/random.hpp"
#include "tests/robot/pioneer/core/fake_controller.hpp"

namespace tandem::pioneer {
namespace {

using std::chrono::milliseconds;

/// A session and a controller joined by a perfect wire, 20 cycles a second.
class Wire {
 public:
  Wire() { session.link_opened(now); }

  void run(double duration_s) {
    for (int i = 0; i < static_cast<int>(std::lround(duration_s * 20.0)); ++i) {
      now += milliseconds{50};
      controller.receive(session.take_output(), now);
      session.receive(controller.step(now), now);
      session.drive(forward_mps, turn_rate_radps);
      session.step(now);
      controller.receive(session.take_output(), now);
      for (auto& event : session.take_events()) events.push_back(std::move(event));
    }
  }
  template <typename Event>
  [[nodiscard]] int count() const {
    return static_cast<int>(std::count_if(
        events.begin(), events.end(), [](const SessionEvent& event) { return std::holds_alternative<Event>(event); }));
  }

  FakeController controller;
  Session session{SessionConfig{}};
  std::vector<SessionEvent> events;
  double forward_mps = 0.0;
  double turn_rate_radps = 0.0;
  Time now{std::chrono::seconds{1000}};
};

TEST(Session, ConnectsAndTellsWhoAnswered) {
  Wire wire;
  wire.run(1.0);

  EXPECT_TRUE(wire.session.is_running());
  ASSERT_EQ(wire.count<Identified>(), 1);
  EXPECT_EQ(std::get<Identified>(wire.events.front()).identity.subclass, "p2at");
  EXPECT_EQ(wire.count<Configured>(), 1);
}

TEST(Session, SendsVelocityZeroBeforeTheHandshakeAndRightAfterOpen) {
  Wire wire;
  wire.run(1.0);

  const auto& seen = wire.controller.seen;
  ASSERT_GT(seen.size(), 8u);
  const std::vector<int> expected{11, 21, 0, 1, 2, 1, 11, 21};  // VEL RVEL SYNC0 SYNC1 SYNC2 OPEN VEL RVEL
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(seen[i].number, expected[i]) << i;
  EXPECT_EQ(seen[0].integer_or(1), 0);
}

TEST(Session, SetsTheAccelerationsAndReadsThemBack) {
  Wire wire;
  wire.run(1.0);

  const auto configured = std::find_if(wire.events.begin(), wire.events.end(), [](const SessionEvent& event) {
    return std::holds_alternative<Configured>(event);
  });
  ASSERT_NE(configured, wire.events.end());
  EXPECT_EQ(std::get<Configured>(*configured).config.acceleration, 300);
  EXPECT_EQ(std::get<Configured>(*configured).config.deceleration, 600);
}

TEST(Session, LeavesTheMotorsOffUntilAskedToDrive) {
  Wire wire;
  wire.run(5.0);
  EXPECT_FALSE(wire.controller.saw(Command::Enable));

  wire.forward_mps = 0.3;
  wire.run(0.5);
  EXPECT_TRUE(wire.controller.motors);
  EXPECT_EQ(wire.controller.actual_mmps, 300);
}

TEST(Session, SendsVelocityZeroBeforeItEnablesTheMotors) {
  Wire wire;
  wire.run(1.0);
  wire.forward_mps = 0.3;
  wire.run(0.3);

  const auto& seen = wire.controller.seen;
  const auto enable = std::find_if(seen.begin(), seen.end(), [](const HostCommand& one) { return one.number == 4; });
  ASSERT_NE(enable, seen.end());
  EXPECT_EQ((enable - 2)->number, 11);
  EXPECT_EQ((enable - 2)->integer_or(1), 0);
  EXPECT_EQ((enable - 1)->number, 21);
}

TEST(Session, PulsesWhileNothingIsAsked) {
  Wire wire;
  wire.run(10.0);
  EXPECT_FALSE(wire.controller.watchdog_fired);
}

TEST(Session, AsksAgainForAConfigThatDoesNotCome) {
  Wire wire;
  wire.controller.answer_to_sync = std::nullopt;
  wire.run(0.5);
  const auto requests = [&] {
    return std::count_if(wire.controller.seen.begin(), wire.controller.seen.end(),
                         [](const HostCommand& one) { return one.number == 18; });
  };
  EXPECT_EQ(requests(), 1);
  wire.run(5.0);
  EXPECT_EQ(requests(), 1) << "it came";
}

TEST(Session, NoRobotAnsweringIsSaidAndNeverReady) {
  Wire wire;
  wire.controller.powered = false;
  wire.run(3.0);

  EXPECT_FALSE(wire.session.is_running());
  ASSERT_EQ(wire.count<GaveUp>(), 1);
  EXPECT_EQ(std::get<GaveUp>(wire.events.back()).why, "no answer");
}

TEST(Session, ConnectsToAControllerThatStillRunsAFormerConnection) {
  Wire wire;
  wire.controller.open = true;
  wire.controller.motors = true;
  wire.controller.commanded_mmps = 400;
  wire.run(2.0);

  EXPECT_TRUE(wire.session.is_running());
  EXPECT_NEAR(wire.controller.travelled_mm, 0.0, 1e-9) << "a pulse alone would have brought its last speed back";
}

TEST(Session, StartsAgainAfterEveryWrongReply) {
  const Packet wrong[] = {{1, {}}, {2, {}}, {packet_type::kSyncCounterOff, {}}, {0x32, {}}, {77, {}}};
  for (const Packet& reply : wrong) {
    SCOPED_TRACE(int{reply.number});
    Wire wire;
    wire.controller.answer_to_sync = reply;
    wire.run(2.0);
    EXPECT_TRUE(wire.session.is_running());
  }
}

TEST(Session, GivesUpOnAControllerThatNamesNoModel) {
  Session session{SessionConfig{}};
  Time now{std::chrono::seconds{1}};
  session.link_opened(now);
  std::vector<SessionEvent> events;
  for (int i = 0; i < 100; ++i) {
    for (std::uint8_t number = 0; number < 3; ++number) session.receive(framed({number, {}}), now += milliseconds{20});
    session.step(now);
    for (auto& event : session.take_events()) events.push_back(std::move(event));
  }
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(std::get<GaveUp>(events[0]).why, "it does not say what robot it is");
}

TEST(Session, SilenceForASecondIsALossAndTheHandshakeStartsOver) {
  Wire wire;
  wire.forward_mps = 0.3;
  wire.run(2.0);
  wire.controller.power_cycle();
  wire.controller.powered = false;
  wire.run(1.2);
  EXPECT_EQ(wire.count<Lost>(), 1);
  EXPECT_FALSE(wire.session.is_running());

  wire.controller.powered = true;
  wire.forward_mps = 0.0;
  wire.run(1.5);
  EXPECT_TRUE(wire.session.is_running());
  EXPECT_EQ(wire.count<Identified>(), 2);
  EXPECT_EQ(wire.controller.newest(Command::Velocity), 0);
  EXPECT_FALSE(wire.controller.motors);
}

TEST(Session, AfterAGapVelocityZeroGoesFirstAndTheRobotDoesNotMove) {
  Wire wire;
  wire.forward_mps = 0.3;
  wire.run(2.0);
  ASSERT_EQ(wire.controller.actual_mmps, 300);

  // We freeze for 3 s; the firmware's watchdog fires after 2.
  wire.now += std::chrono::seconds{3};
  wire.controller.step(wire.now);
  ASSERT_TRUE(wire.controller.watchdog_fired);
  wire.controller.travelled_mm = 0.0;
  wire.session.receive(wire.controller.step(wire.now), wire.now);
  wire.session.drive(0.3, 0.0);
  wire.session.step(wire.now);
  wire.controller.receive(wire.session.take_output(), wire.now);

  EXPECT_EQ(wire.controller.newest(Command::Velocity), 0);
  EXPECT_EQ(wire.controller.actual_mmps, 0);
}

TEST(Session, AStallIsAnsweredByVelocityZeroAtOnce) {
  Wire wire;
  wire.forward_mps = 0.3;
  wire.run(2.0);
  Sip stalled = wire.controller.status;
  stalled.left_stalled = true;
  stalled.flags = sip_flag::kMotorsEnabled;
  wire.session.receive(framed(encode_sip(stalled)), wire.now);

  const Bytes sent = wire.session.take_output();
  EXPECT_EQ(Bytes(sent.begin(), sent.begin() + 9), command(Command::Velocity, 0));
}

TEST(Session, DoesNotEnableTheMotorsWhileTheStopButtonIsIn) {
  Wire wire;
  wire.controller.status.flags = sip_flag::kStopPressed;
  wire.run(1.0);
  wire.forward_mps = 0.3;
  wire.run(3.0);
  EXPECT_FALSE(wire.controller.saw(Command::Enable));
}

TEST(Session, CarriesSmallTurnRatesOverUntilTheyMakeADegree) {
  Wire wire;
  wire.forward_mps = 0.2;
  wire.turn_rate_radps = from_degrees(0.25);
  wire.run(1.0);
  wire.controller.seen.clear();
  wire.run(20.0);
  double sum = 0.0;
  int commands = 0;
  for (const HostCommand& one : wire.controller.seen) {
    if (one.number != static_cast<std::uint8_t>(Command::TurnRate)) continue;
    sum += one.integer_or(0);
    ++commands;
  }
  EXPECT_NEAR(sum / commands, 0.25, 0.01);

  wire.turn_rate_radps = 0.0;
  wire.run(0.1);
  EXPECT_EQ(wire.controller.newest(Command::TurnRate), 0);
}

TEST(Session, NeverSendsMoreThanTheConfiguredVelocities) {
  Wire wire;
  wire.forward_mps = 9.0;
  wire.turn_rate_radps = -9.0;
  wire.run(2.0);
  EXPECT_EQ(wire.controller.newest(Command::Velocity), 500);
  EXPECT_EQ(wire.controller.newest(Command::TurnRate), -60);
  wire.forward_mps = std::nan("");
  wire.run(0.1);
  EXPECT_EQ(wire.controller.newest(Command::Velocity), 0);
}

TEST(Session, LeavesTheMotorsOffAndTheControllerClosedAtTheEnd) {
  Wire wire;
  wire.forward_mps = 0.3;
  wire.run(2.0);
  wire.session.begin_shutdown(wire.now);
  wire.run(0.2);
  EXPECT_TRUE(wire.session.is_closed());
  EXPECT_FALSE(wire.controller.motors);
  EXPECT_FALSE(wire.controller.open);
  EXPECT_EQ(wire.controller.newest(Command::Velocity), 0);
}

TEST(Session, GarbageOnTheSerialLineDisturbsNothingForLong) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng{seed};
    Wire wire;
    wire.run(1.0);
    ASSERT_TRUE(wire.session.is_running());
    for (int i = 0; i < 40; ++i) {
      Bytes garbage(rng.index(60));
      for (auto& byte : garbage) byte = static_cast<std::uint8_t>(rng.index(5) == 0 ? 0xFA + rng.index(2) : rng.bits());
      wire.session.receive(garbage, wire.now);
      wire.run(0.1);
    }
    EXPECT_TRUE(wire.session.is_running());
    EXPECT_EQ(wire.count<Lost>(), 0);
    EXPECT_FALSE(wire.controller.saw(Command::Enable));
  }
}

TEST(BackOff, DoublesUpToFiveSecondsUntilReset) {
  BackOff back_off;
  EXPECT_EQ(back_off.next(), milliseconds{200});
  EXPECT_EQ(back_off.next(), milliseconds{400});
  for (int i = 0; i < 10; ++i) static_cast<void>(back_off.next());
  EXPECT_EQ(back_off.next(), std::chrono::seconds{5});
  back_off.reset();
  EXPECT_EQ(back_off.next(), milliseconds{200});
}

}  // namespace
}  // namespace tandem::pioneer
