#include "robot/laser/core/cola_session.hpp"

#include <gtest/gtest.h>

#include <map>

namespace tandem {
namespace {

using State = LaserSession::State;

constexpr Duration kStep = from_seconds(0.05);

/// Answers by the request's second word as a TiM or an LMS does, but for what a test tells it.
class FakeCola {
 public:
  std::map<std::string, std::string> answers{
      {"DeviceIdent", "sRA DeviceIdent 6 LMS111 5 V1.30"},
      {"SetAccessMode", "sAN SetAccessMode 1"},
      {"LMDscandatacfg", "sWA LMDscandatacfg"},
      {"LMCstartmeas", "sAN LMCstartmeas 0"},
      {"Run", "sAN Run 1"},
      {"STlms", "sRA STlms 7 0 8 00:00:00"},
      {"SCdevicestate", "sFA 3"},
      {"LMDscandata", "sEA LMDscandata 1"},
  };
  std::map<std::string, int> deaf;
  std::string heard;

  std::string answer(const std::string& bytes) {
    std::string out;
    for (const auto& text : reader_.take({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()})) {
      const std::string name = cola::words_of(text).at(1);
      heard += (heard.empty() ? "" : " ") + name;
      if (deaf[name]-- <= 0) out += cola::bytes_of(answers.at(name));
    }
    return out;
  }

 private:
  cola::TelegramReader reader_;
};

std::string scan_bytes(int status = 0) {
  cola::ScanData data{.status = status, .frequency_centihz = 5000};
  data.channels = {{.name = "DIST1", .start_angle = -450'000, .angle_step = 5000, .values = {1000, 2000, 3000}}};
  return cola::bytes_of(cola::text_of(data, "sSN"));
}

struct Conversation {
  explicit Conversation(const LaserConfig& config = {}) : session(config, now) {}

  void step(const std::string& extra = "") {
    const std::string bytes = std::exchange(pending, "") + extra;
    const LaserSession::Output output =
        session.step({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, now);
    sent += output.send;
    pending = laser.answer(output.send);
    scans.insert(scans.end(), output.scans.begin(), output.scans.end());
    now += kStep;
  }
  bool open() {
    for (int i = 0; i < 3000 && session.state() == State::Opening; ++i) step();
    return session.state() == State::Streaming;
  }

  FakeCola laser;
  Time now{};
  ColaSession session;
  std::string sent;
  std::string pending;
  std::vector<DeviceScan> scans;
};

TEST(ColaSession, OpensALaserAndReceivesItsScans) {
  Conversation talk;
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.laser.heard,
            "LMDscandata DeviceIdent SetAccessMode LMDscandatacfg LMCstartmeas Run STlms LMDscandata");
  EXPECT_EQ(talk.session.identity(), "6 LMS111 5 V1.30");
  talk.step(scan_bytes());
  ASSERT_EQ(talk.scans.size(), 1u);
  EXPECT_EQ(talk.scans[0].reading.ranges_m, (std::vector<float>{1, 2, 3}));
  EXPECT_NEAR(talk.scans[0].period_s, 0.02, 1e-9);
}

TEST(ColaSession, AsksForStrengths) {
  LaserConfig config;
  config.intensities = true;
  Conversation talk{config};
  ASSERT_TRUE(talk.open());
  EXPECT_NE(talk.sent.find("sWN LMDscandatacfg 01 00 1 1 0 00 00 0 0 0 0 +1"), std::string::npos);
}

TEST(ColaSession, ATimHasAnotherStateAndMeasuresByItself) {
  Conversation talk;
  talk.laser.answers["LMCstartmeas"] = "sFA 3";
  talk.laser.answers["STlms"] = "sFA 3";
  talk.laser.answers["SCdevicestate"] = "sRA SCdevicestate 1";
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_TRUE(talk.laser.heard.ends_with("STlms SCdevicestate LMDscandata")) << talk.laser.heard;
}

TEST(ColaSession, WaitsForALaserThatWarmsUp) {
  Conversation talk;
  talk.laser.answers["STlms"] = "sRA STlms 1";
  while (talk.now < Time{} + from_seconds(60.0)) talk.step();
  EXPECT_EQ(talk.session.state(), State::Opening);
  EXPECT_EQ(talk.session.reason(), "warms up (state 1)");
  talk.laser.answers["STlms"] = "sRA STlms 7";
  EXPECT_TRUE(talk.open());
}

TEST(ColaSession, DoesNotWaitForEver) {
  Conversation talk;
  talk.laser.answers["STlms"] = "sRA STlms 3";
  EXPECT_FALSE(talk.open());
  EXPECT_EQ(talk.session.reason(), "does not begin to measure: it warms up (state 3)");
}

TEST(ColaSession, IsNotConfusedByScansAmongTheAnswers) {
  Conversation talk;
  for (int i = 0; i < 100 && talk.session.state() == State::Opening; ++i) talk.step(scan_bytes());
  EXPECT_EQ(talk.session.state(), State::Streaming);
}

TEST(ColaSession, AsksAgainWhenAnAnswerIsLost) {
  Conversation talk;
  talk.laser.deaf = {{"DeviceIdent", 1}, {"Run", 2}};
  EXPECT_TRUE(talk.open()) << talk.session.reason();
}

TEST(ColaSession, NamesTheBinaryFormInTheError) {
  Conversation talk;
  talk.step();
  talk.pending = std::string{"\x02\x02\x02\x02\x00\x00\x00\x0DsEA LMDscandata \x00\x33", 26};
  talk.step();
  EXPECT_EQ(talk.session.state(), State::Failed);
  EXPECT_EQ(talk.session.reason(),
            "speaks CoLa B, the binary form: switch it to CoLa A (ASCII) with SICK's SOPAS tool");
}

TEST(ColaSession, FailsWhereTheLaserRefuses) {
  const auto reason = [](const std::string& name, const std::string& answer) {
    Conversation talk;
    talk.laser.answers[name] = answer;
    EXPECT_FALSE(talk.open()) << name;
    return talk.session.reason();
  };
  EXPECT_EQ(reason("SetAccessMode", "sAN SetAccessMode 0"), "refuses the login: has its password been changed?");
  EXPECT_EQ(reason("LMDscandatacfg", "sFA 1"), "refuses sWN LMDscandatacfg 01 00 0 1 0 00 00 0 0 0 0 +1");
  EXPECT_EQ(reason("STlms", "sRA STlms"), "its answer to sRN STlms makes no sense");

  Conversation broken;
  broken.laser.answers["STlms"] = "sFA 3";
  broken.laser.answers["SCdevicestate"] = "sRA SCdevicestate 2";
  EXPECT_FALSE(broken.open());
  EXPECT_EQ(broken.session.reason(), "reports that it is broken (device state 2)");
}

TEST(ColaSession, FailsWithASilentLaser) {
  Conversation talk;
  talk.laser.deaf = {{"LMDscandata", 1000}};
  EXPECT_FALSE(talk.open());
  EXPECT_FALSE(talk.session.was_answered());
  EXPECT_EQ(talk.session.reason(), "does not answer sEN LMDscandata 0");
}

TEST(ColaSession, FailsWhenTheScansDryUp) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  const Time opened = talk.now;
  while (talk.session.state() == State::Streaming) talk.step(cola::bytes_of("sSN LMDscandata 1 1"));
  EXPECT_LE(talk.now - opened, from_seconds(1.2));
  EXPECT_TRUE(talk.session.reason().starts_with("no scan for 1")) << talk.session.reason();
  EXPECT_GT(talk.session.damaged(), 10u);
}

TEST(ColaSession, PassesOnThatTheWindowIsDirty) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  talk.step(scan_bytes(2));
  EXPECT_NE(talk.session.warning().find("dirty"), std::string::npos);
  talk.step(scan_bytes());
  EXPECT_EQ(talk.session.warning(), "");
}

}  // namespace
}  // namespace tandem
