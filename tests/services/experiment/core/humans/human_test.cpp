#include "services/experiment/core/humans/human.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/services/experiment/core/humans/hall.hpp"

namespace tandem::experiment {
namespace {

TEST(Human, ThereIsOneOfEachName) {
  Hall hall;
  for (const std::string& name : human_names()) {
    const Human human = make_human(name, hall.world, 0.75);
    EXPECT_TRUE(human.mind) << name;
    EXPECT_DOUBLE_EQ(human.speed_mps, name == "late" ? 0.45 : 0.75) << name;
  }
}

TEST(Human, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  Hall hall;
  try {
    (void)make_human("obediant", hall.world, 0.75);
    FAIL() << "it was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string{error.what()}.find("obedient, late, own, stubborn, random, announces"), std::string::npos);
  }
}

TEST(Human, OnlyThoseWhoFollowWaitForAPlan) {
  for (const std::string& name : human_names()) {
    Hall hall;
    Human human = make_human(name, hall.world, 0.75);
    Rng rng{1};
    simulator::PhoneUserInput input{.dt_s = 0.5, .map_from_person = {2.0, 2.0, 0.0}, .connected = true};
    bool walks = false;
    for (int i = 0; i < 40 && !walks; ++i) {
      input.now = Time{} + from_seconds(0.5 * i);
      const auto decision = human.mind->step(input, rng);
      walks = decision.new_route_in_map && !decision.new_route_in_map->empty();
    }
    EXPECT_EQ(walks, name != "obedient" && name != "late") << name;
  }
}

}  // namespace
}  // namespace tandem::experiment
