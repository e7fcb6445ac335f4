#include "robot/laser/core/scip_session.hpp"

#include <gtest/gtest.h>

#include "tests/robot/laser/fake_sensor.hpp"

namespace tandem {
namespace {

constexpr Duration kStep = from_seconds(0.05);

/// A session and a sensor in virtual time, talking without a socket.
struct Conversation {
  explicit Conversation(const LaserConfig& config = {}, int baud_rate = 0) : session(config, now, baud_rate) {}

  /// One step: `extra` comes first, then the answer to what the session sent last.
  void step(const std::string& extra = "") {
    const std::string bytes = extra + std::exchange(pending, "");
    const LaserSession::Output output = session.step(bytes_in(bytes), now);
    if (output.baud_rate) rate = output.baud_rate;
    pending = sensor.answer(output.send);
    scans.insert(scans.end(), output.scans.begin(), output.scans.end());
    now += kStep;
  }
  /// Steps until the session is no longer opening; false after 20 s.
  bool open() {
    for (int i = 0; i < 400 && session.state() == ScipSession::State::Opening; ++i) step();
    return session.state() == ScipSession::State::Streaming;
  }

  FakeSensor sensor;
  Time now{};
  ScipSession session;
  std::optional<int> rate;
  std::string pending;
  std::vector<DeviceScan> scans;
};

TEST(ScipSession, OpensASensorAndReceivesItsScans) {
  Conversation talk;
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.sensor.heard, "QT RS VV PP II BM MD");
  EXPECT_EQ(talk.session.identity(), "UTM-30LX, firmware 1.0, serial H1");

  talk.step(talk.sensor.scan(100, 1000));
  talk.step(talk.sensor.scan(200, 2000));

  ASSERT_EQ(talk.scans.size(), 2u);
  EXPECT_EQ(talk.scans[0].reading.ranges_m, std::vector<float>(361, 1.0f));
  EXPECT_EQ(talk.scans[1].clock, 200u);
  EXPECT_NEAR(talk.scans[1].period_s, 0.1, 1e-12);  // three of four turns of 25 ms are left out
  EXPECT_EQ(talk.session.damaged(), 0u);
}

TEST(ScipSession, AsksForTheSensorsWholeFieldUnlessToldOtherwise) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  talk.step(talk.sensor.scan(0, 1));
  EXPECT_EQ(talk.scans.at(0).reading.ranges_m.size(), 361u);

  LaserConfig part;
  part.first_step = 180;
  part.last_step = 900;
  part.cluster = 1;
  Conversation narrow{part};
  ASSERT_TRUE(narrow.open());
  narrow.step(narrow.sensor.scan(0, 1));
  EXPECT_EQ(narrow.scans.at(0).reading.ranges_m.size(), 721u);
}

TEST(ScipSession, SilencesAStreamOfAFormerConnection) {
  Conversation talk;
  talk.sensor.stream({.first_step = 0, .last_step = 1080, .cluster = 1});
  const std::string former = talk.sensor.scan(1, 500);

  talk.step(former.substr(former.size() / 3));  // we begin to listen in the middle of one
  talk.step(former);                            // and another stands before the answer to QT
  ASSERT_TRUE(talk.open()) << talk.session.reason();

  EXPECT_TRUE(talk.scans.empty());
  EXPECT_EQ(talk.session.damaged(), 1u);
}

TEST(ScipSession, GoesOnAgainstAStreamThatWillNotEnd) {
  Conversation talk;
  FakeSensor former;
  former.stream({.first_step = 0, .last_step = 1080, .cluster = 1});
  for (int i = 0; i < 200 && talk.session.state() == ScipSession::State::Opening; ++i) {
    talk.step(former.scan(static_cast<std::uint32_t>(i), 500));
  }
  EXPECT_EQ(talk.session.state(), ScipSession::State::Streaming);
  EXPECT_TRUE(talk.scans.empty()) << "its cluster is not ours";
}

TEST(ScipSession, LeavesTheTimeAdjustState) {
  Conversation talk;
  talk.sensor.in_time_adjust = true;
  ASSERT_TRUE(talk.open());
  EXPECT_TRUE(talk.sensor.heard.starts_with("QT TM QT RS")) << talk.sensor.heard;
}

TEST(ScipSession, SwitchesAnOldSensorToVersionTwo) {
  Conversation talk;
  talk.step();
  talk.pending = "QT\nE\n\n";
  ASSERT_TRUE(talk.open());
  EXPECT_TRUE(talk.sensor.heard.starts_with("QT SCIP2.0 QT RS")) << talk.sensor.heard;
}

TEST(ScipSession, AsksAgainWhenAnAnswerIsLost) {
  Conversation talk;
  talk.sensor.deaf = {{"QT", 2}, {"PP", 1}, {"MD", 1}};
  EXPECT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.sensor.heard, "QT QT QT RS VV PP PP II BM MD MD");
}

TEST(ScipSession, FailsWithASilentSensorAndSaysAtWhat) {
  Conversation talk;
  talk.sensor.deaf = {{"QT", 1000}};
  EXPECT_FALSE(talk.open());
  EXPECT_EQ(talk.session.reason(), "does not answer QT");
  EXPECT_FALSE(talk.session.was_answered());
  EXPECT_LT(talk.now - Time{}, from_seconds(3.0));
}

TEST(ScipSession, FailsWhenTheLaserCannotBeLit) {
  Conversation talk;
  talk.sensor.status = {{"BM", "01"}};
  EXPECT_FALSE(talk.open());
  EXPECT_EQ(talk.session.reason(), "cannot light its laser (answer 01): dirty, still starting, or broken");
  EXPECT_TRUE(talk.session.was_answered());
}

TEST(ScipSession, TakesALaserThatIsLitAlready) {
  Conversation talk;
  talk.sensor.status = {{"BM", "02"}};
  EXPECT_TRUE(talk.open());
}

TEST(ScipSession, FailsWithStepsTheSensorDoesNotHave) {
  LaserConfig config;
  config.last_step = 1081;
  Conversation talk{config};
  EXPECT_FALSE(talk.open());
  EXPECT_EQ(talk.session.reason(),
            "laser.toml: first_step and last_step must lie in [0, 1080], the field of view of this UTM-30LX");
}

TEST(ScipSession, FailsWhenTheScansDryUp) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  talk.step(talk.sensor.scan(0, 1000));
  const Time last_scan = talk.now;
  while (talk.session.state() == ScipSession::State::Streaming) talk.step();
  EXPECT_LE(talk.now - last_scan, from_seconds(1.1));
  EXPECT_TRUE(talk.session.reason().starts_with("no scan for 1")) << talk.session.reason();
}

TEST(ScipSession, TakesAScanWithAWrongCountOfRangesForNoScan) {  // fault S4
  Conversation talk;
  ASSERT_TRUE(talk.open());
  scip::ScanData shorter{.request = {.first_step = 0, .last_step = 1080, .cluster = 3, .skip = 3}};
  while (talk.session.state() == ScipSession::State::Streaming) {
    talk.step(scip::bytes_of(shorter));
    shorter.ranges_mm.assign(360, 1000);  // one too few
  }
  EXPECT_TRUE(talk.scans.empty());
  EXPECT_GT(talk.session.damaged(), 10u);
}

TEST(ScipSession, FailsAtAHardwareErrorAndGoesOnAfterOneThatPassed) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  const std::string echo = scip::line_of({.first_step = 0, .last_step = 1080, .cluster = 3, .skip = 3});
  talk.step(scip::bytes_of(scip::Reply{.echo = echo, .status = "98", .data = {}}));
  EXPECT_EQ(talk.session.state(), ScipSession::State::Streaming);
  talk.step(scip::bytes_of(scip::Reply{.echo = echo, .status = "21", .data = {}}));
  EXPECT_EQ(talk.session.state(), ScipSession::State::Failed);
  EXPECT_EQ(talk.session.reason(), "answers 21, it stopped by a hardware error");
}

TEST(ScipSession, RaisesTheRateOfASerialLineAndThenLeavesItAlone) {
  LaserConfig config;
  config.baud_rate = 115'200;
  Conversation talk{config, 19'200};
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.sensor.heard, "QT VV PP II SS BM MD");
  EXPECT_EQ(talk.rate, 115'200);

  Conversation again{config, 115'200};
  ASSERT_TRUE(again.open());
  EXPECT_EQ(again.sensor.heard, "QT VV PP II BM MD");
  EXPECT_FALSE(again.rate);

  Conversation refused{config, 19'200};
  refused.sensor.status = {{"SS", "04"}};
  EXPECT_FALSE(refused.open());
  EXPECT_TRUE(refused.session.reason().starts_with("laser.toml: this sensor cannot send at baud_rate"));
}

TEST(ScipSession, TriesOtherRatesWhenTheSensorIsLostAfterTheReset) {
  Conversation talk{{}, 115'200};
  talk.sensor.deaf = {{"VV", 1000}};
  EXPECT_FALSE(talk.open());
  EXPECT_FALSE(talk.session.was_answered()) << "RS may have put the line to another rate";
}

TEST(ScipSession, PassesOnWhatTheSensorSaysOfItself) {
  Conversation talk;
  talk.sensor.state = "Sensor is overheated.";
  ASSERT_TRUE(talk.open());
  EXPECT_EQ(talk.session.warning(), "the sensor says: Sensor is overheated.");
}

TEST(ScipSession, RebootsASensorInAnAbnormalState) {
  for (const auto* command : {"BM", "MD"}) {
    Conversation talk;
    talk.sensor.status = {{command, "0L"}};
    EXPECT_FALSE(talk.open());
    EXPECT_EQ(talk.session.reason(), "is in an abnormal state (answer 0L): it is rebooted");
    EXPECT_TRUE(talk.sensor.heard.ends_with("RB RB")) << talk.sensor.heard;
  }
}

TEST(ScipSession, SaysThatASensorHasNoIntensities) {
  LaserConfig config;
  config.intensities = true;
  Conversation talk{config};
  talk.sensor.status = {{"ME", "0E"}};
  EXPECT_FALSE(talk.open());
  EXPECT_EQ(talk.session.reason(), "laser.toml: this UTM-30LX gives no intensities");
}

}  // namespace
}  // namespace tandem
