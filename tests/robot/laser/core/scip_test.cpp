#include "robot/laser/core/scip.hpp"

#include <gtest/gtest.h>

namespace tandem::scip {
namespace {

std::vector<std::uint8_t> bytes(const std::string& text) {
  return {text.begin(), text.end()};
}

/// Both ends of the protocol, of a sensor that sees a wall 1 m ahead of each step.
class ScipTest : public ::testing::Test {
 protected:
  /// What the sensor answers to a line of the driver, and the driver understands.
  std::vector<Reply> answered(const std::string& line) {
    std::vector<Reply> replies;
    for (const std::string& heard : requests.take(bytes(line + "\n"))) {
      const auto request = parse_request(heard);
      if (!request) continue;
      const auto asked = parse_scan_request(*request, sensor);
      if (request->command == "PP") {
        take(bytes_of(Reply{.echo = request->line, .status = "00", .data = parameter_lines(sensor)}), replies);
      } else if (const auto* scan = std::get_if<ScanRequest>(&asked)) {
        const std::vector<std::uint32_t> wall(value_count(*scan), 1000);
        take(bytes_of(ScanData{.request = *scan, .timestamp_ms = 77, .ranges_mm = wall}), replies);
      } else {
        take(bytes_of(Reply{.echo = request->line, .status = std::get<std::string>(asked)}), replies);
      }
    }
    return replies;
  }
  void take(const std::string& sent, std::vector<Reply>& replies) {
    for (auto& reply : parser.take(bytes(sent))) replies.push_back(std::move(reply));
  }

  SensorParameters sensor = urg_04lx();
  LineReader requests{true};
  ReplyParser parser;
};

TEST_F(ScipTest, TheDriverLearnsTheSensorsParameters) {
  const auto replies = answered("PP;who");
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].echo, "PP;who");
  EXPECT_EQ(parse_parameters(replies[0].data), sensor);
}

TEST_F(ScipTest, TheDriverGetsTheScanThatItAskedFor) {
  const ScanRequest asked{.command = "GD", .first_step = 44, .last_step = 725, .cluster = 1};
  const auto replies = answered(line_of(asked));
  ASSERT_EQ(replies.size(), 1U);
  const auto scan = parse_scan(replies[0]);
  ASSERT_TRUE(scan);
  EXPECT_EQ(line_of(scan->request), line_of(asked));
  EXPECT_EQ(scan->timestamp_ms, 77U);
  EXPECT_EQ(scan->ranges_mm, std::vector<std::uint32_t>(682, 1000));
}

TEST_F(ScipTest, StepsThatTheSensorDoesNotHaveAreRefusedAndTheDriverIsToldSo) {
  const auto replies = answered(line_of({.command = "GD", .first_step = 0, .last_step = 1080, .cluster = 1}));
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_NE(replies[0].status, "00");
  EXPECT_FALSE(parse_scan(replies[0]));
  EXPECT_EQ(parser.damaged(), 0U);
}

}  // namespace
}  // namespace tandem::scip
