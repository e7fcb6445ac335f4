// SearchMission::Computation is private to the mission: what it makes of a plan in the making is seen from outside.
#include "services/planner/core/mission/computation.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::milliseconds;
using std::chrono::seconds;

class ComputationTest : public MissionInHall {
 protected:
  /// Computes until it was asked so often whether the slice is over: before each rollout, and before a computation
  /// begins once for what is prepared ahead.
  bool compute(int questions) {
    int asked = 0;
    return mission.step(now, [&] { return asked++ >= questions; });
  }
  [[nodiscard]] std::optional<std::string> hint(const Vector2d& place) {
    return mission.edit_belief({BeliefEdit::Kind::LikelyHere, Disc{place, 1.0}, "very"});
  }
};

TEST_F(ComputationTest, GoesOnWhereItWasHoweverLongTheSlices) {
  run();
  EXPECT_FALSE(compute(1 + 5));
  EXPECT_DOUBLE_EQ(mission.progress(), 5.0 / 20.0);
  pass(milliseconds{100});
  EXPECT_FALSE(compute(5));
  EXPECT_DOUBLE_EQ(mission.progress(), 10.0 / 20.0);
  EXPECT_TRUE(compute(100));
  EXPECT_EQ(mission.activity(), MissionActivity::Idle);
}

TEST_F(ComputationTest, SlicesDoNotChangeThePlan) {
  run();
  while (!compute(3)) continue;
  SearchMission whole(config(), "robot", "person");
  whole.set_map(empty_room(16, 10));
  whole.robot_at(now, robot);
  whole.person_at(now, person, 0.0);
  whole.step(now, kNeverOver);
  whole.run_session("s1", now);
  ASSERT_TRUE(whole.step(now, kNeverOver));
  EXPECT_EQ(whole.plan()->forecast.expected_time_s, mission.plan()->forecast.expected_time_s);
}

TEST_F(ComputationTest, AnEditBeginsItAnewOnceAndTheNextOneOvertakesIt) {
  run();
  EXPECT_FALSE(compute(10));
  EXPECT_FALSE(hint({12, 8}));
  EXPECT_EQ(mission.progress(), 1.0);  // nothing is computed any more
  EXPECT_FALSE(compute(1 + 10));
  EXPECT_FALSE(hint({4, 8}));
  EXPECT_DOUBLE_EQ(mission.progress(), 0.5);  // goes on, without knowing of it
  ASSERT_TRUE(compute(100));
  pass(seconds{4});  // accepted meanwhile: what it does not know of makes another plan
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the person knows something of where it is");
}

TEST_F(ComputationTest, EndsWithTheBestSoFarWhenAskedTo) {
  EXPECT_FALSE(mission.conclude(now));
  run();
  EXPECT_FALSE(compute(1));
  EXPECT_TRUE(mission.conclude(now));
  EXPECT_TRUE(mission.plan());
  EXPECT_FALSE(mission.conclude(now));
}

}  // namespace
}  // namespace tandem
