#include "gateway/server/core/pairing_desk.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

using protocol::UserRole;

/// Tokens t1, t2, ...; sessions s1, s2, ...; the digest of x is #x.
class PairingDeskTest : public testing::Test {
 protected:
  PairingDesk desk_{
      PairingRules{},
      {[this] { return "t" + std::to_string(++tokens_); }, [this] { return "s" + std::to_string(++sessions_); },
       [](const std::string& text) { return "#" + text; }}};
  Slot person_{"participant", UserRole::Participant, "person1", true};
  Slot guest_{"observer", UserRole::Observer, "", false};
  Time now_ = from_stamp_ns(1'000'000'000'000);

  static Duration seconds(double value) { return from_seconds(value); }

 private:
  int tokens_ = 0;
  int sessions_ = 0;
};

TEST_F(PairingDeskTest, TradesATokenForASessionOnce) {
  const std::string token = desk_.issue(person_, now_);
  const auto first = desk_.redeem(token, "phone", now_);
  ASSERT_TRUE(first.paired);
  EXPECT_EQ(first.paired->slot, person_);
  EXPECT_EQ(desk_.session_of(first.paired->session, now_)->slot, person_);
  EXPECT_FALSE(desk_.redeem(token, "thief", now_).paired);
}

TEST_F(PairingDeskTest, TokenExpiresAfterFiveMinutes) {
  const std::string token = desk_.issue(person_, now_);
  EXPECT_TRUE(desk_.has_token("participant", now_ + seconds(299)));
  EXPECT_FALSE(desk_.has_token("participant", now_ + seconds(299), seconds(2)));
  EXPECT_FALSE(desk_.redeem(token, "phone", now_ + seconds(300)).paired);
}

TEST_F(PairingDeskTest, SessionExpiresAfterEightHours) {
  const auto session = desk_.redeem(desk_.issue(person_, now_), "phone", now_).paired->session;
  EXPECT_TRUE(desk_.session_of(session, now_ + seconds(8 * 3600 - 1)));
  EXPECT_FALSE(desk_.session_of(session, now_ + seconds(8 * 3600)));
  EXPECT_FALSE(desk_.session_of("", now_));
  EXPECT_FALSE(desk_.session_of("guess", now_));
}

TEST_F(PairingDeskTest, ANewTokenVoidsTheOneBefore) {
  const std::string old = desk_.issue(person_, now_);
  const std::string fresh = desk_.issue(person_, now_);
  EXPECT_FALSE(desk_.redeem(old, "phone", now_).paired);
  EXPECT_TRUE(desk_.redeem(fresh, "phone", now_).paired);
}

TEST_F(PairingDeskTest, AnotherPhoneTakesAnExclusiveSlot) {
  const auto first = desk_.redeem(desk_.issue(person_, now_), "phone1", now_).paired->session;
  const auto second = desk_.redeem(desk_.issue(person_, now_), "phone2", now_).paired->session;
  EXPECT_FALSE(desk_.session_of(first, now_));
  EXPECT_TRUE(desk_.session_of(second, now_));
  EXPECT_EQ(desk_.take_ended(), std::vector<std::string>{"#" + first});
  EXPECT_TRUE(desk_.take_ended().empty());
}

TEST_F(PairingDeskTest, ObserversDoNotPushEachOtherOut) {
  const auto first = desk_.redeem(desk_.issue(guest_, now_), "phone1", now_).paired->session;
  (void)desk_.redeem(desk_.issue(guest_, now_), "phone2", now_);
  EXPECT_TRUE(desk_.session_of(first, now_));
}

TEST_F(PairingDeskTest, FiveWrongGuessesInAMinuteLockTheAddressForAMinute) {
  const std::string token = desk_.issue(person_, now_);
  for (int i = 0; i < 5; ++i) {
    const auto guess = desk_.redeem("guess", "thief", now_ + seconds(i));
    EXPECT_EQ(guess.refusal, PairingDesk::Refusal::WrongToken);
  }
  EXPECT_EQ(desk_.redeem(token, "thief", now_ + seconds(5)).refusal, PairingDesk::Refusal::Locked);
  EXPECT_TRUE(desk_.redeem(token, "phone", now_ + seconds(5)).paired);

  const std::string next = desk_.issue(person_, now_ + seconds(65));
  EXPECT_TRUE(desk_.redeem(next, "thief", now_ + seconds(65)).paired);
}

TEST_F(PairingDeskTest, SlowGuessesDoNotLock) {
  for (int i = 0; i < 20; ++i) {
    const auto guess = desk_.redeem("guess", "clumsy", now_ + seconds(16.0 * i));
    EXPECT_EQ(guess.refusal, PairingDesk::Refusal::WrongToken);
  }
}

TEST_F(PairingDeskTest, SessionsOutliveTheDesk) {
  const auto session = desk_.redeem(desk_.issue(person_, now_), "phone", now_).paired->session;
  const auto kept = desk_.kept(now_);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0], (PairingDesk::Kept{"#" + session, "participant", now_ + seconds(8 * 3600)}));
  EXPECT_TRUE(desk_.kept(now_ + seconds(8 * 3600)).empty());

  PairingDesk next{PairingRules{},
                   {[] { return "t"; }, [] { return "s"; }, [](const auto& text) { return "#" + text; }}};
  EXPECT_FALSE(next.session_of(session, now_));
  next.restore(kept[0], person_);
  EXPECT_EQ(next.session_of(session, now_)->slot, person_);
  EXPECT_FALSE(next.session_of(session, now_ + seconds(8 * 3600)));
}

}  // namespace
}  // namespace tandem::gateway
