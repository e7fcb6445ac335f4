#include "services/relay/core/peer_seat.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double time_s) {
  return Time{} + from_seconds(1000.0 + time_s);
}

TEST(PeerSeat, OneHostAloneHasIt) {
  PeerSeat seat;
  for (int second = 0; second < 5; ++second) EXPECT_EQ(seat.rival_of("laptop1", at(second)), std::nullopt);
}

TEST(PeerSeat, TwoThatSpeakByTurnsAreRivals) {
  PeerSeat seat;
  EXPECT_EQ(seat.rival_of("laptop1", at(0.0)), std::nullopt);
  EXPECT_EQ(seat.rival_of("laptop2", at(0.1)), std::nullopt);  // the first may have been taken away
  EXPECT_EQ(seat.rival_of("laptop1", at(0.2)), "laptop2");
  EXPECT_EQ(seat.rival_of("laptop2", at(0.3)), "laptop1");
}

TEST(PeerSeat, ASecondHostThatFollowsUponAnotherIsNone) {
  PeerSeat seat;
  EXPECT_EQ(seat.rival_of("laptop1", at(0.0)), std::nullopt);
  EXPECT_EQ(seat.rival_of("laptop1", at(0.2)), std::nullopt);
  for (const double time_s : {0.4, 0.6, 0.8}) EXPECT_EQ(seat.rival_of("laptop2", at(time_s)), std::nullopt);
}

TEST(PeerSeat, OneOfTwoHasItWhenTheOtherHasBeenSilentFor3Seconds) {
  PeerSeat seat;
  std::ignore = seat.rival_of("laptop1", at(0.0));
  std::ignore = seat.rival_of("laptop2", at(0.1));
  std::ignore = seat.rival_of("laptop1", at(0.2));
  EXPECT_EQ(seat.rival_of("laptop1", at(3.0)), "laptop2");
  EXPECT_EQ(seat.rival_of("laptop1", at(3.2)), std::nullopt);
}

}  // namespace
}  // namespace tandem
