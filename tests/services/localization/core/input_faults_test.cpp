#include "services/localization/core/input_faults.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tandem {
namespace {

TEST(InputFaults, CountsEachByItself) {
  InputFaults faults;
  faults.add(InputFault::ScanStuck);
  faults.add(InputFault::ScanStuck);
  faults.add(InputFault::OdometryJump);
  EXPECT_EQ(faults.count(InputFault::ScanStuck), 2U);
  EXPECT_EQ(faults.count(InputFault::OdometryJump), 1U);
  EXPECT_EQ(faults.count(InputFault::ScanOutOfOrder), 0U);
}

TEST(InputFaults, EachHasANameOfItsOwn) {
  EXPECT_EQ(std::set<std::string>(kInputFaultNames.begin(), kInputFaultNames.end()).size(), kInputFaultNames.size());
  EXPECT_STREQ(kInputFaultNames[static_cast<std::size_t>(InputFault::OdometryJump)], "odometry_jump");
}

TEST(InputFaults, TellsWhatCameSince) {
  InputFaults faults;
  faults.add(InputFault::ScanStuck);
  const InputFaults before = faults;
  faults.add(InputFault::ScanStuck);
  faults.add(InputFault::ScanStuck);
  faults.add(InputFault::OdometryJump);

  EXPECT_EQ(faults.since(before).text(), "scan_stuck 2, odometry_jump 1");
  EXPECT_EQ(faults.since(faults).text(), "");
}

}  // namespace
}  // namespace tandem
