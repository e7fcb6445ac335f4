#pragma once

#include "services/experiment/core/humans/person_world.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem::experiment {

/// A person of the tests: sees 3 m all around.
inline Searcher hall_person() {
  Searcher person;
  person.id = "person";
  person.speed_mps = 0.75;
  person.radius_m = 0.25;
  person.preferred_clearance_m = 0.5;
  person.view_max_m = 3.0;
  return person;
}

inline SearchAreaOptions hall_options() {
  SearchAreaOptions options;
  options.start_in_map = {2.0, 2.0};
  return options;
}

/// An empty hall of the given inner size [m]; its inner corner is at (0.5, 0.5).
struct Hall {
  explicit Hall(int width_m = 16, int height_m = 10)
      : world(empty_room(width_m, height_m), hall_person(), hall_options()) {}
  PersonWorld world;
};

}  // namespace tandem::experiment
