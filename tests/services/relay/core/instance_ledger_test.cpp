#include "services/relay/core/instance_ledger.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

constexpr InstanceLedger::Key kFirst{1};
constexpr InstanceLedger::Key kSecond{2};

TEST(InstanceLedger, NamesWhatDidNotComeAgainOnce) {
  InstanceLedger ledger;
  ledger.came(kFirst);
  ledger.came(kSecond);
  ledger.begin_round();
  ledger.came(kFirst);
  EXPECT_EQ(ledger.take_missing(), std::vector{kSecond});
  EXPECT_TRUE(ledger.take_missing().empty());
}

TEST(InstanceLedger, WhatHadEndedIsNotMissing) {
  InstanceLedger ledger;
  ledger.came(kFirst);
  ledger.ended(kFirst);
  ledger.begin_round();
  EXPECT_TRUE(ledger.take_missing().empty());
}

TEST(InstanceLedger, LivingIsWhatCameInAnyRoundAndDidNotEnd) {
  InstanceLedger ledger;
  ledger.came(kFirst);
  ledger.begin_round();
  ledger.came(kSecond);
  EXPECT_EQ(ledger.living(), (std::vector{kFirst, kSecond}));
  ledger.ended(kFirst);
  EXPECT_EQ(ledger.living(), std::vector{kSecond});
}

TEST(InstanceLedger, NothingIsMissingInTheFirstRound) {
  InstanceLedger ledger;
  ledger.came(kFirst);
  EXPECT_TRUE(ledger.take_missing().empty());
}

}  // namespace
}  // namespace tandem
