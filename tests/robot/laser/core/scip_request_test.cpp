#include "robot/laser/core/scip_request.hpp"

#include <gtest/gtest.h>

namespace tandem::scip {
namespace {

std::vector<std::string> lines_in(LineReader& reader, std::string_view text) {
  return reader.take(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string refusal(const std::string& line) {
  const auto parsed = parse_scan_request(*parse_request(line), utm_30lx());
  const auto* status = std::get_if<std::string>(&parsed);
  return status != nullptr ? *status : "accepted";
}

TEST(ScipLineReader, PutsLinesTogetherHoweverTheyWereSplit) {
  LineReader reader;
  EXPECT_TRUE(lines_in(reader, "Q").empty());
  EXPECT_EQ(lines_in(reader, "T\nVV\nP"), (std::vector<std::string>{"QT", "VV"}));
  EXPECT_EQ(lines_in(reader, "P\n"), std::vector<std::string>{"PP"});
}

TEST(ScipLineReader, OfASensorTakesCarriageReturnsToo) {
  LineReader reader{true};
  EXPECT_EQ(lines_in(reader, "QT\rVV\r\nPP\n"), (std::vector<std::string>{"QT", "VV", "PP"}));
}

TEST(ScipLineReader, DoesNotGrowWithoutEnd) {
  LineReader reader;
  const std::string flood(100'000, 'x');
  EXPECT_TRUE(lines_in(reader, flood).empty());
  EXPECT_EQ(lines_in(reader, "\n").at(0).size(), LineReader::kMostCharacters);
}

TEST(ScipRequest, HasACommandParametersAndATag) {
  const auto request = parse_request("MD0044072501000;laser-1");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->command, "MD");
  EXPECT_EQ(request->parameters, "0044072501000");
  EXPECT_EQ(request->tag, "laser-1");
  EXPECT_EQ(parse_request("SCIP2.0")->command, "SCIP2.0");
  EXPECT_EQ(parse_request("TM2")->parameters, "2");
  EXPECT_FALSE(parse_request("Q"));
}

TEST(ScipScanRequest, IsWrittenWithFixedWidths) {
  const ScanRequest stream{.first_step = 0, .last_step = 1080, .cluster = 3, .skip = 3};
  EXPECT_EQ(line_of(stream), "MD0000108003300");
  EXPECT_EQ(line_of({.command = "GD", .first_step = 44, .last_step = 725}), "GD0044072501");
}

TEST(ScipScanRequest, ComesBackFromItsLine) {
  const ScanRequest request{"ME", 44, 725, 2, 1, 50, "me"};
  EXPECT_EQ(std::get<ScanRequest>(parse_scan_request(*parse_request(line_of(request)))), request);
}

TEST(ScipScanRequest, IsRefusedWithTheStatusOfWhatIsWrong) {
  EXPECT_EQ(refusal("MD0000108001000"), "accepted");
  EXPECT_EQ(refusal("MD00x0108001000"), "01");
  EXPECT_EQ(refusal("MD0000x08001000"), "02");
  EXPECT_EQ(refusal("MD00001080x1000"), "03");
  EXPECT_EQ(refusal("MD0000108101000"), "04");  // the last step is 1080
  EXPECT_EQ(refusal("MD0500040001000"), "05");
  EXPECT_EQ(refusal("MD0000108001x00"), "06");
  EXPECT_EQ(refusal("MD00001080010x0"), "07");
  EXPECT_EQ(refusal("MD000010800100"), "0C");
  EXPECT_EQ(refusal("MD00001080010000"), "0D");
  EXPECT_EQ(refusal("XX"), "0E");
}

TEST(ScipScanRequest, CountsItsValues) {
  EXPECT_EQ(value_count({.first_step = 0, .last_step = 1080, .cluster = 1}), 1081u);
  EXPECT_EQ(value_count({.first_step = 0, .last_step = 1080, .cluster = 0}), 1081u);
  EXPECT_EQ(value_count({.first_step = 0, .last_step = 1080, .cluster = 3}), 361u);
  EXPECT_EQ(value_count({.first_step = 44, .last_step = 725, .cluster = 2}), 341u);
}

}  // namespace
}  // namespace tandem::scip
