#include "services/planner/core/inform/person_knowledge.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kRobot = 0;
constexpr std::size_t kPerson = 1;

/// Two rooms with a wall between them at 6 m: what is on the one side is not seen from the other.
class PersonKnowledgeTest : public ::testing::Test {
 protected:
  static OccupancyGrid two_rooms() {
    std::vector<std::string> drawing(10, "#" + std::string(10, '.') + "#" + std::string(10, '.') + "#");
    drawing.front() = drawing.back() = std::string(23, '#');
    drawing[1][11] = '.';  // a door
    return room(drawing);
  }
  void robot_at(double x, double y) {
    for (int i = 0; i < 2; ++i, now += milliseconds{500}) knowledge.robot_looks(now, {x, y, 0.0}, sight);
  }
  double exposure_at(double x, double y) { return knowledge.belief().exposure(*area.cell_at(Eigen::Vector2d{x, y})); }

  OccupancyGrid map = two_rooms();
  SearchArea area{map, start_at(2, 2)};
  Observability sight{map, area, 4.0};
  Time now = from_stamp_ns(1'700'000'000'000'000'000);
  PersonKnowledge knowledge{SearchBelief(uniform_prior(area, {2, 2}, 0.0)), Watch{kRobot, test_robot()},
                            Watch{kPerson, test_person()}};
};

TEST_F(PersonKnowledgeTest, TheyKnowWhatTheyLookedAt) {
  knowledge.person_looks(now, {2, 2, 0}, sight);
  knowledge.person_looks(now + milliseconds{1000}, {2, 2, 0}, sight);
  EXPECT_DOUBLE_EQ(exposure_at(3, 2), 0.5);
}

TEST_F(PersonKnowledgeTest, TheyKnowWhatTheRobotLooksAtOnlyWhileTheyHaveItInSight) {
  robot_at(8, 2);
  EXPECT_EQ(exposure_at(10, 2), 0.0);  // nobody is known to be there
  knowledge.person_looks(now, {2, 2, 0}, sight);
  robot_at(8, 2);
  EXPECT_EQ(exposure_at(10, 2), 0.0);  // behind the wall
  knowledge.person_is_lost();
  knowledge.person_looks(now, {9, 3, 0}, sight);
  robot_at(8, 2);
  EXPECT_DOUBLE_EQ(exposure_at(10, 2), 0.5);  // 0.5 s at 1 per s
  knowledge.person_is_lost();
  robot_at(8, 2);
  EXPECT_DOUBLE_EQ(exposure_at(10, 2), 0.5);
}

TEST_F(PersonKnowledgeTest, TheyKnowWhatTheySaidAndWhatTheyTookNoticeOf) {
  knowledge.says({BeliefEdit::Kind::Searched, Disc{{3.0, 2.0}, 0.6}, "well", "person"}, area, kPerson);
  EXPECT_DOUBLE_EQ(exposure_at(3, 2), kSearchedWell);
  EXPECT_FALSE(knowledge.knows("hole"));
  knowledge.learns("hole");
  EXPECT_TRUE(knowledge.knows("hole"));
  knowledge.forgets("hole");
  EXPECT_FALSE(knowledge.knows("hole"));
  SearchBelief truth(knowledge.belief().prior());
  truth.look(kRobot, {*area.cell_at(Eigen::Vector2d{10, 2})}, 1.0, 2.0);
  knowledge.learns(truth);
  EXPECT_DOUBLE_EQ(exposure_at(10, 2), 2.0);
  EXPECT_EQ(exposure_at(3, 2), 0.0);
}

}  // namespace
}  // namespace tandem
