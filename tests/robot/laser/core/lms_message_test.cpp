#include "robot/laser/core/lms_message.hpp"

#include <gtest/gtest.h>

namespace tandem::lms {
namespace {

TEST(LmsMessage, AQuarterDegreeExistsWithAHundredDegreesOnly) {
  EXPECT_TRUE(exists({180, 100}));
  EXPECT_TRUE(exists({180, 50}));
  EXPECT_TRUE(exists({100, 25}));
  EXPECT_FALSE(exists({180, 25}));
  EXPECT_FALSE(exists({90, 50}));
  EXPECT_FALSE(exists({180, 10}));
}

TEST(LmsMessage, AScanHasAValueAtBothEndsOfTheField) {
  EXPECT_EQ(value_count({180, 100}), 181u);
  EXPECT_EQ(value_count({180, 50}), 361u);
  EXPECT_EQ(value_count({100, 100}), 101u);
  EXPECT_EQ(value_count({100, 50}), 201u);
  EXPECT_EQ(value_count({100, 25}), 401u);
  EXPECT_EQ(turns_per_scan({100, 100}), 1);
  EXPECT_EQ(turns_per_scan({100, 25}), 4);
}

TEST(LmsMessage, KnowsTheRatesOfTheLine) {
  for (const int rate : {9'600, 19'200, 38'400, 500'000}) EXPECT_EQ(rate_of_mode(*mode_of_rate(rate)), rate);
  EXPECT_FALSE(mode_of_rate(115'200));
  EXPECT_FALSE(rate_of_mode(mode::kStream));
}

TEST(LmsMessage, TheMeasuringModeSaysHowManyBitsAreRange) {
  EXPECT_EQ(range_bits({.measuring_mode = 0}), 13);
  EXPECT_EQ(range_bits({.measuring_mode = 3}), 14);
  EXPECT_EQ(range_bits({.measuring_mode = 6}), 15);
  EXPECT_EQ(range_bits({.measuring_mode = 15}), 16);
  EXPECT_DOUBLE_EQ(range_max_m({.measuring_mode = 0, .millimetres = true}), 8.182);  // 8183 is "out of range"
  EXPECT_DOUBLE_EQ(range_max_m({.measuring_mode = 0, .millimetres = false}), 81.82);
  EXPECT_TRUE(has_intensity({.measuring_mode = 1}));
  EXPECT_FALSE(has_intensity({.measuring_mode = 6}));
}

TEST(LmsMessage, AFormatIsSetInTheConfigurationAndReadBack) {
  const ConfigBlock block(32, 0xEE);
  const RangeFormat format{.measuring_mode = 6, .millimetres = false};
  ConfigBlock changed = with_format(block, format);
  EXPECT_EQ(format_of(changed), format);
  changed[5] = 0xEE;
  changed[6] = 0xEE;
  EXPECT_EQ(changed, block) << "nothing else was touched";
}

TEST(LmsMessage, AScanGoesThereAndBack) {
  for (const bool millimetres : {true, false}) {
    const ScanData scan{.millimetres = millimetres, .values = {1, 8191, 0xFFFF}, .status = 0x81};
    EXPECT_EQ(parse_scan(payload_of(scan)), scan);
  }
}

TEST(LmsMessage, AScanMayHaveIndexBytesBeforeItsStatus) {
  Payload payload = payload_of({.values = {5, 6}, .status = 3});
  payload.insert(payload.end() - 1, {0xAA, 0xBB});
  const auto scan = parse_scan(payload);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->values, (std::vector<std::uint16_t>{5, 6}));
  EXPECT_EQ(scan->status, 3);
}

TEST(LmsMessage, AScanWithAWrongCountIsNone) {  // fault S4
  Payload payload = payload_of({.values = {5, 6}});
  payload.pop_back();
  EXPECT_FALSE(parse_scan(payload));
  payload.insert(payload.end(), 4, 0);
  EXPECT_FALSE(parse_scan(payload));
  EXPECT_FALSE(parse_scan(payload_of({})));
  Payload partial = payload_of({.values = {5, 6}});
  partial[2] |= 0x20;
  EXPECT_FALSE(parse_scan(partial));
}

TEST(LmsMessage, TheStatusByteTellsOfDirtAndErrors) {
  EXPECT_EQ(complaint_of(0), "");
  EXPECT_EQ(complaint_of(1), "");
  EXPECT_NE(complaint_of(0x80).find("dirty"), std::string::npos);
  EXPECT_NE(complaint_of(3).find("error"), std::string::npos);
  EXPECT_NE(complaint_of(4).find("fatal"), std::string::npos);
}

}  // namespace
}  // namespace tandem::lms
