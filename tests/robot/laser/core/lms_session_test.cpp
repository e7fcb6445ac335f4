#include "robot/laser/core/lms_session.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <map>

namespace tandem {
namespace {

using State = LaserSession::State;

constexpr Duration kStep = from_seconds(0.05);

/// A laser that answers as told; each request is heard as its payload.
class FakeLms {
 public:
  lms::ConfigBlock block = lms::ConfigBlock(32, 0);
  std::map<std::uint8_t, int> deaf = {};              ///< So many requests of a command are not heard.
  std::map<std::uint8_t, lms::Payload> instead = {};  ///< Answers other than the usual ones, by command.
  std::vector<lms::Payload> heard;

  std::string answer(const std::string& bytes) {
    std::string out;
    const std::vector<std::uint8_t> taken{bytes.begin(), bytes.end()};
    for (const lms::Event& event : reader_.take(taken)) out += answer_to(event.payload);
    return out;
  }
  static std::string scan(std::size_t count, std::uint8_t status = 0) {
    const lms::ScanData data{.values = std::vector<std::uint16_t>(count, 1000), .status = status};
    return lms::bytes_of(lms::kFromLaser, lms::payload_of(data));
  }
  [[nodiscard]] std::string commands() const {
    std::string all;
    for (const auto& payload : heard) {
      char text[4];
      std::snprintf(text, sizeof text, "%02X ", payload[0]);
      all += text;
    }
    return all;
  }

 private:
  std::string answer_to(const lms::Payload& request) {
    heard.push_back(request);
    const std::uint8_t code = request[0];
    if (deaf[code]-- > 0) return "";
    lms::Payload payload{static_cast<std::uint8_t>(code | 0x80)};
    if (const auto told = instead.find(code); told != instead.end()) {
      payload = told->second;
    } else if (code == lms::command::kMode) {
      payload.push_back(0);
    } else if (code == lms::command::kVariant || code == lms::command::kWriteConfig) {
      payload.push_back(1);
    } else if (code == lms::command::kReadConfig) {
      payload.insert(payload.end(), block.begin(), block.end());
    } else if (code == lms::command::kType) {
      const std::string type = "LMS200;30106;V02.10";
      payload.insert(payload.end(), type.begin(), type.end());
    }
    payload.push_back(0);
    return std::string(1, lms::kAcknowledged) + lms::bytes_of(lms::kFromLaser, payload);
  }
  lms::TelegramReader reader_{lms::kToLaser};
};

/// A session and a laser in virtual time.
struct Conversation {
  explicit Conversation(const LaserConfig& config = {}, int baud_rate = 38'400) : session(config, now, baud_rate) {}

  void step(const std::string& extra = "") {
    const std::string bytes = extra + std::exchange(pending, "");
    const std::vector<std::uint8_t> received{bytes.begin(), bytes.end()};
    const LaserSession::Output output = session.step(received, now);
    if (output.baud_rate) rate = output.baud_rate;
    pending = laser.answer(output.send);
    scans.insert(scans.end(), output.scans.begin(), output.scans.end());
    now += kStep;
  }
  bool open() {
    for (int i = 0; i < 1000 && session.state() == State::Opening; ++i) step();
    return session.state() == State::Streaming;
  }

  FakeLms laser;
  Time now{};
  LmsSession session;
  std::optional<int> rate;
  std::string pending;
  std::vector<DeviceScan> scans;
};

TEST(LmsSession, OpensALaserAndReceivesItsScans) {
  Conversation talk;
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.laser.commands(), "20 3A 31 74 3B 20 ");
  EXPECT_EQ(talk.session.identity(), "LMS200;30106;V02.10");
  EXPECT_FALSE(talk.rate) << "it is at the usual rate already";
  talk.step(FakeLms::scan(361));
  ASSERT_EQ(talk.scans.size(), 1u);
  EXPECT_EQ(talk.scans[0].reading.ranges_m, std::vector<float>(361, 1.0f));
}

TEST(LmsSession, RaisesTheRateAfterTheAnswerAtTheOldOne) {
  Conversation talk{{}, 9'600};
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.rate, 38'400);
  EXPECT_EQ(talk.laser.commands(), "20 3A 31 74 3B 20 31 20 ");  // asks for its status at the new one
}

TEST(LmsSession, LeavesTheRateAloneWhereThereIsNone) {
  Conversation talk{{}, 0};
  ASSERT_TRUE(talk.open());
  EXPECT_FALSE(talk.rate);
}

TEST(LmsSession, WritesItsFlashOnlyForAnotherFormat) {
  LaserConfig config;
  config.range_format = "32m";
  Conversation talk{config};
  ASSERT_TRUE(talk.open()) << talk.session.reason();
  EXPECT_EQ(talk.laser.commands(), "20 3A 31 74 20 77 3B 20 ");
  const lms::Payload& written = talk.laser.heard[5];
  EXPECT_EQ(lms::format_of({written.begin() + 1, written.end()}),
            (lms::RangeFormat{.measuring_mode = 6, .millimetres = true}));

  Conversation again{config};
  again.laser.block = {written.begin() + 1, written.end()};
  ASSERT_TRUE(again.open());
  EXPECT_EQ(again.laser.commands(), "20 3A 31 74 3B 20 ");
}

TEST(LmsSession, AsksForStrengthsInTheMeasuringMode) {
  LaserConfig config;
  config.range_format = "8m";
  config.intensities = true;
  Conversation talk{config};
  ASSERT_TRUE(talk.open());
  talk.step(FakeLms::scan(361));
  EXPECT_EQ(talk.scans.at(0).reading.intensities.size(), 361u);
}

TEST(LmsSession, GoesOnAgainstAStreamOfAFormerConnection) {
  Conversation talk;
  for (int i = 0; i < 200 && talk.session.state() == State::Opening; ++i) talk.step(FakeLms::scan(181));
  EXPECT_EQ(talk.session.state(), State::Streaming) << talk.session.reason();
  EXPECT_TRUE(talk.scans.empty()) << "their count is not ours";
}

TEST(LmsSession, AsksAgainWhenAnAnswerIsLost) {
  Conversation talk;
  talk.laser.deaf = {{lms::command::kMode, 2}, {lms::command::kReadConfig, 1}};
  EXPECT_TRUE(talk.open()) << talk.session.reason();
}

TEST(LmsSession, FailsWithASilentLaserAndSaysAtWhichRate) {
  Conversation talk;
  talk.laser.deaf = {{lms::command::kMode, 1000}};
  EXPECT_FALSE(talk.open());
  EXPECT_FALSE(talk.session.was_answered());
  EXPECT_EQ(talk.session.reason(), "does not answer at 38400 baud (waits for the answer to the order to be quiet)");
  EXPECT_LT(talk.now - Time{}, from_seconds(2.0));
}

TEST(LmsSession, FailsWhereTheLaserRefuses) {
  Conversation variant;
  variant.laser.instead = {{lms::command::kVariant, {0xBB, 0x00}}};
  EXPECT_FALSE(variant.open());
  EXPECT_NE(variant.session.reason().find("resolution_deg"), std::string::npos);

  LaserConfig config;
  config.range_format = "80m";
  Conversation format{config};
  format.laser.block[5] = 6;
  format.laser.instead = {{lms::command::kWriteConfig, {0xF7, 0x00}}};
  EXPECT_FALSE(format.open());
  EXPECT_EQ(format.session.reason(), "refuses its new configuration");

  Conversation fault;
  fault.laser.instead = {{lms::command::kMode, {0xA0, 0x02}}};
  EXPECT_FALSE(fault.open());
  EXPECT_EQ(fault.session.reason(), "reports a fault at the order to be quiet");

  Conversation short_block;
  short_block.laser.block.resize(3);
  EXPECT_FALSE(short_block.open());
  EXPECT_EQ(short_block.session.reason(), "its configuration makes no sense");
}

TEST(LmsSession, FailsWithSettingsThatNoLaserHas) {
  LaserConfig config;
  config.resolution_deg = 0.25;
  EXPECT_EQ(LmsSession(config, Time{}, 9'600).state(), State::Failed);
  config.field_of_view_deg = 100;
  EXPECT_EQ(LmsSession(config, Time{}, 9'600).state(), State::Opening);
  config.baud_rate = 57'600;
  EXPECT_EQ(LmsSession(config, Time{}, 9'600).reason(),
            "laser.toml: baud_rate of an LMS 2xx is 9600, 19200, 38400 or 500000");
}

TEST(LmsSession, BeginsAgainWhenTheLaserWasSwitchedOn) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  talk.step(lms::bytes_of(lms::kFromLaser, lms::Payload{lms::command::kPowerOn, 'L', 'M', 'S', 0}));
  EXPECT_EQ(talk.session.state(), State::Failed);
  EXPECT_EQ(talk.session.reason(), "was switched on just now");
}

TEST(LmsSession, FailsWhenTheScansDryUp) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  const Time last_scan = talk.now;
  talk.step(FakeLms::scan(361));
  while (talk.session.state() == State::Streaming) talk.step(FakeLms::scan(360));  // one too few: none
  EXPECT_LE(talk.now - last_scan, from_seconds(1.2));
  EXPECT_EQ(talk.scans.size(), 1u);
  EXPECT_GT(talk.session.damaged(), 10u);
}

TEST(LmsSession, PassesOnThatTheWindowIsDirty) {
  Conversation talk;
  ASSERT_TRUE(talk.open());
  talk.step(FakeLms::scan(361, lms::kPolluted));
  EXPECT_EQ(talk.session.warning(), "the laser says that its window is dirty: clean it");
  talk.step(FakeLms::scan(361));
  EXPECT_EQ(talk.session.warning(), "");
}

TEST(LmsSession, TellsTheLaserToBeQuietWhenItLeaves) {
  EXPECT_EQ(LmsSession(LaserConfig{}, Time{}, 0).farewell(),
            lms::bytes_of(lms::kToLaser, lms::mode_request(lms::mode::kOnRequest)));
}

}  // namespace
}  // namespace tandem
