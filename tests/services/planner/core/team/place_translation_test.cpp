#include "services/planner/core/team/place_translation.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(PlaceTranslation, OfOneCapabilityAPlaceStandsForItself) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person(), test_person()});
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  EXPECT_EQ(PlaceTranslation(ground).translated(0, 1, 3), 3);
}

TEST(PlaceTranslation, OfTwoCapabilitiesTheNearestLookoutStandsForAPlace) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person(), test_robot()}, 1.5);
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  const PlaceTranslation translation(ground);
  const ActionSet& person = search.world().actions(0);
  const ActionSet& robot = search.world().actions(1);
  for (int place = 0; place < person.lookouts(); ++place) {
    const int there = translation.translated(0, 1, place);
    for (int other = 0; other < robot.lookouts(); ++other) {
      EXPECT_LE((robot.place(there) - person.place(place)).norm(), (robot.place(other) - person.place(place)).norm());
    }
  }
}

}  // namespace
}  // namespace tandem
