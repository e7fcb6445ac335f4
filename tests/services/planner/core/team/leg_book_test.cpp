#include "services/planner/core/team/leg_book.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(LegBook, OfASearcherToWhomSeenIsFoundItHoldsWhatComesIntoViewOnTheWay) {
  Searcher person = test_person();
  person.detection_rate_per_s = std::numeric_limits<double>::infinity();
  SearchCase search(empty_room(16, 10), {3, 3}, {person});
  const Leg& whole = search.world().actions(0).leg(0, 1);
  const CompactLeg& leg = search.world().book(0).leg(0, 1);

  ASSERT_TRUE(leg.possible);
  EXPECT_FLOAT_EQ(leg.duration_s, static_cast<float>(whole.duration_s));
  EXPECT_LT(leg.cells.size(), whole.seen.size());
  for (const float enter_s : leg.enter_s) EXPECT_GT(enter_s, 0.0F);
}

TEST(LegBook, WithADetectionRateItSaysHowMuchOfACellsMassIsLeft) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  const CompactLeg& leg = search.world().book(0).leg(0, 1);

  ASSERT_EQ(leg.kept.size(), leg.cells.size());
  for (std::size_t i = 0; i < leg.cells.size(); ++i) EXPECT_NEAR(leg.kept[i], std::exp(-0.5F * leg.stay_s[i]), 1e-6F);
}

TEST(LegBook, KeepsALegWhereItIsAndForgetsThoseOfAddedPlaces) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  LegBook& book = search.world().book(0);
  ActionSet& actions = search.world().actions(0);
  const CompactLeg* kept = &book.leg(0, 1);
  const int start = *actions.add_place({3, 3}, 1.0);
  const float from_the_left_s = book.leg(start, 1).duration_s;
  EXPECT_EQ(&book.leg(0, 1), kept);

  search.world().forget_added_places();
  ASSERT_EQ(*actions.add_place({13, 8}, 1.0), start);  // the same number, another place
  EXPECT_NE(book.leg(start, 1).duration_s, from_the_left_s);
  EXPECT_EQ(&book.leg(0, 1), kept);
}

TEST(LegBook, PreparingFindsTheLegsOfOneLookoutAfterTheOther) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  int steps = 0;
  while (search.world().prepare_next()) ++steps;
  EXPECT_EQ(steps, search.world().actions(0).lookouts());
}

}  // namespace
}  // namespace tandem
