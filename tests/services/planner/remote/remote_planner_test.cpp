#include "services/planner/remote/remote_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/planner/remote/remote_messages.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

/// A hall of 8 x 4 m in two rooms; one walker at (1.5, 1.5).
class RemotePlannerInTwoRooms : public testing::Test {
 protected:
  static SearchWorldOptions options() {
    SearchWorldOptions options;
    options.area.start_in_map = {1.5, 1.5};
    Searcher walker;
    walker.id = "walker";
    walker.speed_mps = 1.0;
    walker.view_max_m = 2.0;
    options.searchers = {walker};
    return options;
  }
  static std::vector<std::string> rows() {
    std::vector<std::string> rows(42, "#" + std::string(80, '.') + "#");
    rows.front() = rows.back() = std::string(82, '#');
    for (std::size_t row = 1; row < 26; ++row) rows[row][41] = '#';
    return rows;
  }
  void SetUp() override {
    problem_.world = &world_;
    SearchMember member;
    member.pose = {1.5, 1.5, 0.0};
    problem_.members = {member};
    problem_.masses = {uniform_prior(world_.area(), {1.5, 1.5}, 0.0)};
  }
  std::string refusal(const std::string& answer) {
    try {
      (void)remote::paths_of_answer(answer, problem_);
    } catch (const RemotePlannerError& error) {
      return error.what();
    }
    return "";
  }

  SearchWorld world_{{test::ascii_map(rows(), 0.1)}, options()};
  SearchProblem problem_;
};

TEST_F(RemotePlannerInTwoRooms, APathIsTakenAsItIs) {
  const auto paths = remote::paths_of_answer(R"({"paths": [[[0, 1.5, 1.5], [2, 3.5, 1.5]]]})", problem_);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_DOUBLE_EQ(paths.front().duration_s(), 2.0);
}

TEST_F(RemotePlannerInTwoRooms, APathThatCannotBeWalkedIsRefused) {
  EXPECT_NE(refusal(R"({"paths": [[[0, 1.5, 1.5], [1, 3.5, 1.5]]]})").find("faster than"), std::string::npos);
  EXPECT_NE(refusal(R"({"paths": [[[0, 1.5, 3.5], [9, 7.0, 3.5]]]})").find("does not begin"), std::string::npos);
  EXPECT_NE(refusal(R"({"paths": [[[0, 1.5, 1.5], [2, 1.5, 3.5], [9, 7.0, 3.5]]]})").find("through a wall"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"paths": [[[0, 1.5, 1.5], [-1, 1.5, 1.5]]]})").find("back in time"), std::string::npos);
  EXPECT_NE(refusal(R"({"paths": [[]]})").find("is empty"), std::string::npos);
}

TEST_F(RemotePlannerInTwoRooms, AnAnswerThatIsNoPlanIsRefused) {
  EXPECT_NE(refusal("hello").find("no plan"), std::string::npos);
  EXPECT_NE(refusal(R"({"paths": []})").find("0 paths for 1 members"), std::string::npos);
}

TEST_F(RemotePlannerInTwoRooms, TheCommittedPathComesFirst) {
  problem_.members.front().committed = {{{0.0, {1.5, 1.5}}, {1.0, {2.5, 1.5}}}};
  EXPECT_NE(refusal(R"({"paths": [[[0, 1.5, 1.5], [1, 1.5, 2.5]]]})").find("committed"), std::string::npos);
  EXPECT_EQ(refusal(R"({"paths": [[[0, 1.5, 1.5], [3, 4.0, 1.5]]]})"),
            "the path of 'walker' does not begin with the "
            "committed one");
  EXPECT_EQ(refusal(R"({"paths": [[[0, 1.5, 1.5], [1, 2.5, 1.5], [2, 2.5, 2.5]]]})"), "");
}

TEST_F(RemotePlannerInTwoRooms, AProgramPlans) {
  RemotePlanner planner({.command = R"(while read -r line; do case $line in *'"type":"plan"'*)
    echo '{"paths": [[[0, 1.5, 1.5], [1, 2.5, 1.5]]]}';; esac; done)"});
  planner.begin(problem_, Rng{1});
  EXPECT_DOUBLE_EQ(planner.best().paths.front().duration_s(), 1.0);
  EXPECT_GT(planner.best().forecast.probability_found, 0.0);
}

TEST_F(RemotePlannerInTwoRooms, AProgramThatEndsIsReported) {
  RemotePlanner planner({.command = "true"});
  EXPECT_THROW(planner.begin(problem_, Rng{1}), RemotePlannerError);
}

TEST_F(RemotePlannerInTwoRooms, TheExampleFindsItsWayRoundTheWall) {
  RemotePlanner planner(
      {.command = "python3 " + std::string(TANDEM_SOURCE_DIR) + "/bench/planning/examples/nearest_unseen.py"});
  // All that is left lies behind the wall.
  for (int cell = 0; cell < world_.area().size(); ++cell) {
    if (world_.area().point(cell).x() < 5.0) problem_.masses.front()[static_cast<std::size_t>(cell)] = 0.0;
  }
  planner.begin(problem_, Rng{1});
  const TimedPath path = planner.best().paths.front();
  EXPECT_GT(path.points.back().point_in_map.x(), 4.2);
  EXPECT_GT(planner.best().forecast.probability_found, 0.0);
}

TEST_F(RemotePlannerInTwoRooms, TheExampleGoesRoundTheWallFromWhereverItStands) {
  RemotePlanner planner(
      {.command = "python3 " + std::string(TANDEM_SOURCE_DIR) + "/bench/planning/examples/nearest_unseen.py"});
  for (int cell = 0; cell < world_.area().size(); ++cell) {
    if (world_.area().point(cell).x() < 5.0) problem_.masses.front()[static_cast<std::size_t>(cell)] = 0.0;
  }
  // Around the wall's end, at (4.1, 1.6), an arm's length away.
  for (int i = 0; i < 60; ++i) {
    const double angle_rad = 0.1 * i;
    const Pose2 pose{4.15 + 0.45 * std::cos(angle_rad), 1.65 + 0.45 * std::sin(angle_rad), 0.0};
    problem_.members.front().pose = pose;
    EXPECT_NO_THROW(planner.begin(problem_, Rng{1})) << pose.x << ", " << pose.y;
  }
}

}  // namespace
}  // namespace tandem
