#include "robot/pioneer/base_diagnosis.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

class BaseDiagnosisTest : public testing::Test {
 protected:
  BaseDiagnosisTest() {
    base_.connected = base_.motors_enabled = true;
    base_.watchdog_s = 0.5;
    base_.deceleration_mps2 = 0.6;
  }
  /// What it says after `seconds` like this.
  std::string after(double seconds) {
    std::string said;
    for (const Time end = now_ + from_seconds(seconds); now_ < end; now_ += std::chrono::milliseconds{50}) {
      said = diagnosis_.step({base_, decision_, bad_checksums_, 0.6}, now_);
      bad_checksums_ += damaging_ ? 1 : 0;
    }
    return said;
  }

  safety::BaseInput base_;
  safety::GateDecision decision_;
  std::uint64_t bad_checksums_ = 0;
  bool damaging_ = false;
  BaseDiagnosis diagnosis_;
  Time now_{std::chrono::seconds{1000}};
};

TEST_F(BaseDiagnosisTest, SaysNothingOfABaseThatIsWell) {
  decision_.motion = {0.3, 0.0};
  EXPECT_EQ(after(30.0), "");
}

TEST_F(BaseDiagnosisTest, NamesMotorsThatDoNotEngage) {
  decision_.motion = {0.3, 0.0};
  base_.motors_enabled = false;
  EXPECT_EQ(after(1.9), "");
  EXPECT_NE(after(0.3).find("motors do not engage"), std::string::npos);
  base_.motors_enabled = true;
  EXPECT_EQ(after(0.1), "");
}

TEST_F(BaseDiagnosisTest, NamesALineThatDamagesPacketsAndForgetsItWhenThatIsOver) {
  damaging_ = true;
  EXPECT_NE(after(21.0).find("damaged"), std::string::npos);
  damaging_ = false;
  EXPECT_EQ(after(21.0), "");
}

TEST_F(BaseDiagnosisTest, NamesTheBatteryByHowLittleIsLeft) {
  decision_.battery_warning = true;
  EXPECT_NE(after(0.1).find("is low"), std::string::npos);
  decision_.battery_return = true;
  EXPECT_NE(after(0.1).find("nearly empty"), std::string::npos);
}

TEST_F(BaseDiagnosisTest, NamesBrakesAndAWatchdogThatAreNotAsAsked) {
  base_.deceleration_mps2 = 0.3;
  EXPECT_NE(after(0.1).find("deceleration"), std::string::npos);
  base_.deceleration_mps2 = 0.6;
  base_.watchdog_s = 2.0;
  EXPECT_NE(after(0.1).find("watchdog"), std::string::npos);
}

}  // namespace
}  // namespace tandem
