#include "services/localization/core/agreement_monitor.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

TEST(AgreementMonitor, CallsLostWhatHasLongBeenUncertain) {
  AgreementMonitor monitor{0.7, from_seconds(2.0)};

  EXPECT_EQ(monitor.add(at(0.0), 0.9), LocalizationStatus::Ok);
  EXPECT_EQ(monitor.add(at(1.0), 0.6), LocalizationStatus::Uncertain);
  EXPECT_EQ(monitor.add(at(2.9), 0.6), LocalizationStatus::Uncertain);
  EXPECT_EQ(monitor.add(at(3.0), 0.6), LocalizationStatus::Lost);
  EXPECT_EQ(monitor.add(at(3.1), 0.7), LocalizationStatus::Ok);
}

TEST(AgreementMonitor, CountsFromTheLatestScanThatFitted) {
  AgreementMonitor monitor{0.7, from_seconds(2.0)};

  EXPECT_EQ(monitor.add(at(0.0), 0.5), LocalizationStatus::Uncertain);
  EXPECT_EQ(monitor.add(at(1.5), 0.8), LocalizationStatus::Ok);
  EXPECT_EQ(monitor.add(at(2.5), 0.5), LocalizationStatus::Uncertain);
}

}  // namespace
}  // namespace tandem
