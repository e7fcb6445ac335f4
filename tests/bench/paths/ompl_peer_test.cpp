#include "bench/paths/ompl_peer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tandem::bench {
namespace {

PathCase small_case() {
  PathCase one;
  one.family = "S1u";
  one.seed = 3;
  one.room = OccupancyGrid{3, 2, 0.5, {1.0, -1.0, 0.0}, CellState::Free};
  one.room.set({2, 0}, CellState::Occupied);
  one.start_in_map = {1.25, -0.75};
  one.goal_in_map = {2.25, -0.25};
  one.shortest_m = 4.0;
  return one;
}

TEST(OmplPeer, ItsQuestionHoldsTheRoomFromTheLowestRowOn) {
  EXPECT_EQ(ompl_question(small_case()), "3 2 0.5 1 -1\n..#\n...\n1.25 -0.75 2.25 -0.25\n");
}

TEST(OmplPeer, ItsAnswerIsALengthForEachBudget) {
  const auto records = ompl_answer("10 0.000000\n50 5.000000\n", small_case(), "RRTstar", {10.0, 50.0});
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].planner, "OMPL RRTstar");
  EXPECT_EQ(records[0].length_m, 0.0);
  EXPECT_EQ(records[1].budget_ms, 50.0);
  EXPECT_EQ(records[1].length_m, 5.0);
  EXPECT_EQ(records[1].shortest_m, 4.0);
}

TEST(OmplPeer, AnAnswerThatIsCutOffIsRefused) {
  EXPECT_THROW((void)ompl_answer("10 3.0\n", small_case(), "RRTstar", {10.0, 50.0}), std::runtime_error);
  EXPECT_THROW((void)ompl_answer("", small_case(), "RRTstar", {10.0}), std::runtime_error);
}

TEST(OmplPeer, AProgramThatFailsIsRefused) {
  EXPECT_THROW((void)ompl_ways("false", small_case(), "RRTstar", {10.0}), std::runtime_error);
}

}  // namespace
}  // namespace tandem::bench
