#include "services/common/config.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

struct DriveConfig {
  double speed_mps = 0.5;
  std::int64_t retries = 3;
  bool reverse = false;
  std::string device = "tcp:127.0.0.1:8101";
  std::string mode = "slow";
  std::vector<double> gains{1.0, 2.0};
  std::vector<std::string> peers;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("speed_mps", speed_mps, Range{0.0, 2.0});
    visitor.field("retries", retries, Range{0, 10});
    visitor.field("reverse", reverse);
    visitor.field("device", device);
    visitor.field("mode", mode, {"slow", "fast"});
    visitor.field("gains", gains, Range{0.0, 9.0});
    visitor.field("peers", peers);
  }
};

/// What loading `toml` says is wrong; empty if it loads.
std::string complaint_about(const std::string& toml) {
  try {
    (void)parse_config<DriveConfig>(toml, "drive.toml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Config, FieldsNotNamedKeepTheirDefault) {
  const auto config = parse_config<DriveConfig>("speed_mps = 1.25\npeers = [\"a\", \"b\"]\n");

  EXPECT_DOUBLE_EQ(config.speed_mps, 1.25);
  EXPECT_EQ(config.peers, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(config.retries, 3);
  EXPECT_EQ(config.mode, "slow");
}

TEST(Config, AWholeNumberIsARealNumberToo) {
  EXPECT_DOUBLE_EQ(parse_config<DriveConfig>("speed_mps = 2").speed_mps, 2.0);
}

TEST(Config, UnknownConfigKeyIsRefusedWithFileLineAndTheNearestKnownKey) {
  EXPECT_EQ(complaint_about("retries = 1\n\nsped_mps = 1.0\n"),
            "drive.toml:3: sped_mps: unknown key; the nearest known key is speed_mps");
}

TEST(Config, AnUnknownTableIsAnUnknownConfigKeyToo) {
  EXPECT_EQ(complaint_about("[devices]\nport = 1\n"),
            "drive.toml:1: devices: unknown key; the nearest known key is device");
}

TEST(Config, ValuesOutsideTheirRangeAreRefusedWithTheRange) {
  EXPECT_EQ(complaint_about("speed_mps = 2.5"), "drive.toml:1: speed_mps: 2.5 is outside [0, 2]");
  EXPECT_EQ(complaint_about("\nretries = -1"), "drive.toml:2: retries: -1 is outside [0, 10]");
  EXPECT_EQ(complaint_about("gains = [1.0, 10.0]"), "drive.toml:1: gains: 10 is outside [0, 9]");
  EXPECT_EQ(complaint_about("speed_mps = 2.0"), "");  // the range is closed
}

TEST(Config, WhatIsNoFiniteNumberIsRefused) {
  EXPECT_NE(complaint_about("speed_mps = nan"), "");
  EXPECT_NE(complaint_about("speed_mps = inf"), "");
}

TEST(Config, ValuesOfTheWrongTypeAreRefused) {
  EXPECT_EQ(complaint_about("speed_mps = \"fast\""), "drive.toml:1: speed_mps is not a number");
  EXPECT_EQ(complaint_about("retries = 1.5"), "drive.toml:1: retries is not a whole number");
  EXPECT_EQ(complaint_about("reverse = 1"), "drive.toml:1: reverse is neither true nor false");
  EXPECT_EQ(complaint_about("device = 8101"), "drive.toml:1: device is not a \"string\"");
  EXPECT_EQ(complaint_about("gains = 1.0"), "drive.toml:1: gains is not a [list]");
  EXPECT_EQ(complaint_about("peers = [1]"), "drive.toml:1: peers is not a \"string\"");
}

TEST(Config, AWordThatIsNotAllowedIsRefusedWithThoseThatAre) {
  EXPECT_EQ(complaint_about("mode = \"medium\""), "drive.toml:1: mode is \"medium\"; allowed: slow, fast");
}

TEST(Config, ASyntaxErrorIsRefusedWithFileAndLine) {
  EXPECT_TRUE(complaint_about("retries = 1\nspeed_mps 2.0\n").starts_with("drive.toml:2: "));
}

TEST(Config, AFileThatIsNotThereIsNamedWithARemedy) {
  try {
    (void)load_config<DriveConfig>("no/such/drive.toml");
    FAIL() << "loaded a config that is not there";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string{error.what()}, "no/such/drive.toml: cannot be read; give the folder with --config");
  }
}

TEST(Config, WhatIsWrittenLoadsAsTheSame) {
  DriveConfig config;
  config.speed_mps = 0.1;
  config.retries = 7;
  config.reverse = true;
  config.device = R"(C:\"serial" 1)";
  config.mode = "fast";
  config.gains = {0.25, 1e-7};
  config.peers = {"10.0.0.1"};

  const auto read = parse_config<DriveConfig>(write_config(config));

  EXPECT_EQ(read.speed_mps, config.speed_mps);
  EXPECT_EQ(read.retries, config.retries);
  EXPECT_EQ(read.reverse, config.reverse);
  EXPECT_EQ(read.device, config.device);
  EXPECT_EQ(read.mode, config.mode);
  EXPECT_EQ(read.gains, config.gains);
  EXPECT_EQ(read.peers, config.peers);
}

}  // namespace
}  // namespace tandem
