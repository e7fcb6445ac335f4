#include "services/common/clock.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using std::chrono::milliseconds;

/// The time since the start [ms].
long since_start(const Clock& clock) {
  return std::chrono::duration_cast<milliseconds>(clock.now() - Time{}).count();
}

TEST(ManualClock, StandsStillUntilItIsMovedAndNeverGoesBack) {
  ManualClock clock;
  EXPECT_EQ(since_start(clock), 0);

  clock.advance(milliseconds{30});
  EXPECT_EQ(since_start(clock), 30);
  clock.wait_until(Time{} + milliseconds{20}, {});
  EXPECT_EQ(since_start(clock), 30);
  clock.wait_until(Time{} + milliseconds{50}, {});
  EXPECT_EQ(since_start(clock), 50);
}

TEST(Metronome, BeatsOncePerPeriod) {
  ManualClock clock;
  Metronome beat{clock, milliseconds{100}};

  beat.wait({});
  EXPECT_EQ(since_start(clock), 100);
  clock.advance(milliseconds{40});  // work within the period does not shift the next beat
  beat.wait({});
  EXPECT_EQ(since_start(clock), 200);
}

TEST(Metronome, SkipsMissedBeatsAndNeverCatchesUp) {
  ManualClock clock;
  Metronome beat{clock, milliseconds{100}};

  clock.advance(milliseconds{350});  // beats at 100, 200 and 300 are missed
  beat.wait({});
  EXPECT_EQ(since_start(clock), 350);  // one at once
  beat.wait({});
  EXPECT_EQ(since_start(clock), 400);  // and on in the old rhythm
  beat.wait({});
  EXPECT_EQ(since_start(clock), 500);
}

TEST(SteadyClock, IsUnixTimeAndNeverGoesBack) {
  const SteadyClock clock;
  const Time first = clock.now();
  EXPECT_GT(first, Time{} + std::chrono::hours{24 * 365 * 50});  // after 2019
  EXPECT_GE(clock.now(), first);
  EXPECT_EQ(clock.epoch(), 0);
}

TEST(SteadyClock, AnInterruptedWaitEndsAtOnce) {
  SteadyClock clock;
  int asked = 0;
  clock.wait_until(clock.now() + std::chrono::hours{1}, [&asked] {
    ++asked;
    return true;
  });
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace tandem
