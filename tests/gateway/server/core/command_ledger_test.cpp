#include "gateway/server/core/command_ledger.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

using Arrival = CommandLedger::Arrival;

TEST(CommandLedger, TakesEachCommandOnce) {
  CommandLedger ledger;
  EXPECT_EQ(ledger.arrive("phone", 1), Arrival::New);
  EXPECT_EQ(ledger.arrive("phone", 2), Arrival::New);
  EXPECT_EQ(ledger.arrive("phone", 1), Arrival::Duplicate);
  EXPECT_EQ(ledger.arrive("phone", 2), Arrival::Duplicate);
}

TEST(CommandLedger, CoversOnlyCommandsWhoseFateIsKnown) {
  CommandLedger ledger;
  for (std::uint64_t i = 4; i <= 6; ++i) std::ignore = ledger.arrive("phone", i);
  EXPECT_EQ(ledger.settled_up_to("phone"), 3u);  // before the first that this gateway has seen
  ledger.settle("phone", {5, "applied", ""});
  EXPECT_EQ(ledger.settled_up_to("phone"), 3u);
  ledger.settle("phone", {4, "refused", "why not"});
  EXPECT_EQ(ledger.settled_up_to("phone"), 5u);
  ledger.settle("phone", {6, "applied", ""});
  EXPECT_EQ(ledger.settled_up_to("phone"), 6u);
}

TEST(CommandLedger, AcceptsNothingAfterAGapUntilItIsFilled) {
  CommandLedger ledger;
  EXPECT_EQ(ledger.arrive("phone", 1), Arrival::New);
  EXPECT_EQ(ledger.arrive("phone", 3), Arrival::Gap);
  EXPECT_EQ(ledger.arrive("phone", 2), Arrival::New);
  EXPECT_EQ(ledger.arrive("phone", 3), Arrival::New);
}

TEST(CommandLedger, GoesOnWithAPhoneFromBeforeARestart) {
  CommandLedger ledger;
  EXPECT_EQ(ledger.arrive("phone", 7), Arrival::New);
  EXPECT_EQ(ledger.arrive("phone", 8), Arrival::New);
}

TEST(CommandLedger, CountsEachPhoneByItself) {
  CommandLedger ledger;
  EXPECT_EQ(ledger.arrive("one", 1), Arrival::New);
  EXPECT_EQ(ledger.arrive("two", 1), Arrival::New);
  EXPECT_EQ(ledger.settled_up_to("nobody"), 0u);
}

TEST(CommandLedger, RemembersWhatBecameOfTheNewest64) {
  CommandLedger ledger;
  (void)ledger.arrive("phone", 1);
  for (std::uint64_t i = 1; i <= 70; ++i) ledger.settle("phone", {i, "applied", ""});
  const auto results = ledger.results_of("phone");
  ASSERT_EQ(results.size(), 64u);
  EXPECT_EQ(results.front().sequence, 7u);
  EXPECT_EQ(results.back().sequence, 70u);
}

TEST(CommandLedger, ForgetsTheLeastRecentlyUsedPhoneOfTooMany) {
  CommandLedger ledger;
  (void)ledger.arrive("first", 5);
  (void)ledger.arrive("second", 5);
  (void)ledger.arrive("first", 6);
  for (int i = 0; i < 255; ++i) (void)ledger.arrive("other" + std::to_string(i), 1);
  EXPECT_EQ(ledger.settled_up_to("first"), 4u);
  EXPECT_EQ(ledger.settled_up_to("second"), 0u);
}

}  // namespace
}  // namespace tandem::gateway
