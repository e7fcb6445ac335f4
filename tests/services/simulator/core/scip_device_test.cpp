#include "services/simulator/core/scip_device.hpp"

#include <gtest/gtest.h>

namespace tandem::simulator {
namespace {

std::string send(ScipDevice& device, const std::string& text, Time now = Time{}) {
  return device.receive(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now);
}

std::vector<scip::Reply> replies(const std::string& text) {
  scip::ReplyParser parser;
  return parser.take(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Each beam measures a tenth of its step in metres; counts how many were asked for.
struct Ruler {
  std::size_t asked = 0;
  Measure measure() {
    return [this](std::span<const Beam> beams) {
      asked += beams.size();
      std::vector<double> ranges;
      for (const auto& beam : beams) ranges.push_back(beam.share_of_turn * 1440 / 10.0);
      return ranges;
    };
  }
};

TEST(ScipDevice, TellsItsParameters) {
  ScipDevice device{{}, Time{}};
  const auto answers = replies(send(device, "VV\nPP\nII\n"));
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].status, "00");
  EXPECT_EQ(scip::parse_parameters(answers[1].data), scip::utm_30lx());
  EXPECT_EQ(answers[2].echo, "II");
}

TEST(ScipDevice, TheUrgStartsAtStep44ForThoseWhoTakeZeroForMissing) {
  ScipDevice device{{.parameters = scip::urg_04lx()}, Time{}};
  const auto answers = replies(send(device, "PP\n"));
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(scip::parse_parameters(answers[0].data)->first_step, 44);
}

TEST(ScipDevice, StreamsEveryFourthTurnWithOneBeamForThreeSteps) {
  ScipDevice device{{}, Time{}};
  EXPECT_EQ(send(device, "MD0000108003300\n"), "MD0000108003300\n00P\n\n");
  Ruler ruler;
  int scans = 0;
  for (int turn = 0; turn < 8; ++turn) {
    const std::string text = device.end_turn(Time{} + turn * std::chrono::milliseconds{25}, ruler.measure());
    if (text.empty()) continue;
    ++scans;
    const auto scan = scip::parse_scan(replies(text).at(0));
    ASSERT_TRUE(scan);
    ASSERT_EQ(scan->ranges_mm.size(), 361U);
    EXPECT_EQ(scan->timestamp_ms, static_cast<std::uint32_t>(turn) * 25U);
    EXPECT_EQ(scan->ranges_mm[10], 3100U);     // steps 30, 31, 32
    EXPECT_EQ(scan->ranges_mm[360], 108000U);  // step 1080 alone
  }
  EXPECT_EQ(scans, 2);
  EXPECT_EQ(ruler.asked, 2U * 361U);
}

TEST(ScipDevice, CountsTheScansThatAreLeftAndThenRests) {
  ScipDevice device{{}, Time{}};
  (void)send(device, "MS0540054000002\n");
  Ruler ruler;
  EXPECT_EQ(replies(device.end_turn(Time{}, ruler.measure())).at(0).echo, "MS0540054000001");
  EXPECT_EQ(replies(device.end_turn(Time{}, ruler.measure())).at(0).echo, "MS0540054000000");
  EXPECT_TRUE(device.end_turn(Time{}, ruler.measure()).empty());
}

TEST(ScipDevice, GivesASingleScanOnceTheLaserIsOn) {
  ScipDevice device{{}, Time{}};
  EXPECT_EQ(replies(send(device, "GD0500051001\n")).at(0).status, "10");
  EXPECT_EQ(replies(send(device, "BM\n")).at(0).status, "00");
  EXPECT_EQ(replies(send(device, "BM\n")).at(0).status, "02");
  EXPECT_TRUE(send(device, "GD0500051001\n").empty());
  Ruler ruler;
  const auto scan = scip::parse_scan(replies(device.end_turn(Time{}, ruler.measure())).at(0));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->ranges_mm.size(), 11U);
  EXPECT_EQ(scan->ranges_mm[0], 50000U);
  EXPECT_TRUE(device.end_turn(Time{}, ruler.measure()).empty());
}

TEST(ScipDevice, QuitEndsTheStream) {
  ScipDevice device{{}, Time{}};
  (void)send(device, "ME0000108001000\n");
  EXPECT_TRUE(device.is_measuring());
  EXPECT_EQ(send(device, "QT\n"), "QT\n00P\n\n");
  EXPECT_FALSE(device.is_measuring());
}

TEST(ScipDevice, RefusesStepsItDoesNotHaveAndCommandsItDoesNotKnow) {
  ScipDevice device{{}, Time{}};
  EXPECT_EQ(replies(send(device, "MD0000108101000\n")).at(0).status, "04");
  EXPECT_EQ(replies(send(device, "ZZ\n")).at(0).status, "0E");
  EXPECT_EQ(replies(send(device, "MD12\n")).at(0).status, "0C");
  EXPECT_EQ(replies(send(device, "Z\n")).at(0).status, "0C");
}

TEST(ScipDevice, ItsClockWrapsAfterTwentyFourBits) {
  ScipDevice device{{.clock_start_ms = 0xFFFFF0}, Time{}};
  (void)send(device, "MD0540054001000\n");
  Ruler ruler;
  const auto turn = [&](int ms) {
    return scip::parse_scan(replies(device.end_turn(Time{} + std::chrono::milliseconds{ms}, ruler.measure())).at(0))
        ->timestamp_ms;
  };
  EXPECT_EQ(turn(15), 0xFFFFFFU);
  EXPECT_EQ(turn(16), 0U);
  EXPECT_EQ(turn(40), 24U);
}

TEST(ScipDevice, TellsItsTimeInAdjustModeOnly) {
  ScipDevice device{{}, Time{}};
  EXPECT_EQ(replies(send(device, "TM1\n")).at(0).status, "04");
  EXPECT_EQ(replies(send(device, "TM0\n")).at(0).status, "00");
  const auto told = replies(send(device, "TM1\n", Time{} + std::chrono::milliseconds{1234}));
  ASSERT_EQ(told.at(0).data.size(), 1U);
  EXPECT_EQ(told[0].data[0].substr(0, 4), scip::timestamp_data(1234));
  EXPECT_EQ(replies(send(device, "MD0000108003300\n")).at(0).status, "10");
  EXPECT_EQ(replies(send(device, "TM2\n")).at(0).status, "00");
}

TEST(ScipDevice, AnOldOneAnswersWithEUntilItIsToldTheVersion) {
  ScipDevice device{{.wakes_in_version_1 = true}, Time{}};
  EXPECT_EQ(send(device, "QT\n"), "QT\nE\n\n");
  EXPECT_EQ(send(device, "SCIP2.0\n"), "SCIP2.0\n00P\n\n");
  EXPECT_EQ(send(device, "QT\n"), "QT\n00P\n\n");
}

TEST(ScipDevice, HearsNothingAtAWrongRate) {
  ScipDevice device{{.baud_rate = 19'200}, Time{}};
  device.set_line_rate(115'200);
  EXPECT_EQ(send(device, "QT\n"), "");
  device.set_line_rate(19'200);
  EXPECT_EQ(replies(send(device, "SS115201\n")).at(0).status, "04");
  EXPECT_EQ(replies(send(device, "SS019200\n")).at(0).status, "03");
  EXPECT_EQ(replies(send(device, "SS115200\n")).at(0).status, "00");
  EXPECT_EQ(send(device, "QT\n"), "");
  device.set_line_rate(115'200);
  EXPECT_EQ(replies(send(device, "RS\n")).at(0).status, "00");
  EXPECT_EQ(device.baud_rate(), 19'200) << "RS puts the line back";
}

TEST(ScipDevice, StreamsNoFasterThanItsLine) {
  ScipDevice device{urg_04lx_serial(), Time{}};
  device.set_line_rate(19'200);
  (void)send(device, "SCIP2.0\nMD0044072501000\n");
  Ruler ruler;
  int scans = 0;
  for (int turn = 0; turn < 100; ++turn) {
    scans += device.end_turn(Time{} + turn * device.turn_period(), ruler.measure()).empty() ? 0 : 1;
  }
  EXPECT_EQ(scans, 9);  // 2.1 kB take 1.1 s, so every twelfth turn of 0.1 s
}

TEST(ScipDevice, IsMendedByARebootThatIsAskedForTwice) {
  ScipDevice device{{.status = "0L"}, Time{}};
  EXPECT_EQ(replies(send(device, "BM\n")).at(0).status, "0L");
  EXPECT_EQ(replies(send(device, "RB\n")).at(0).status, "01");
  EXPECT_EQ(replies(send(device, "RB\n", Time{} + std::chrono::seconds{2})).at(0).status, "01") << "too late";
  EXPECT_EQ(replies(send(device, "RB\n", Time{} + std::chrono::seconds{2})).at(0).status, "00");
  EXPECT_EQ(replies(send(device, "BM\n")).at(0).status, "00");
}

TEST(ScipDevice, MayHaveNoIntensities) {
  ScipDevice device{{.has_intensities = false}, Time{}};
  EXPECT_EQ(replies(send(device, "ME0000108001000\n")).at(0).status, "0E");
}

}  // namespace
}  // namespace tandem::simulator
