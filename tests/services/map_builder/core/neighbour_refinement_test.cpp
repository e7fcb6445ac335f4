#include "services/map_builder/core/neighbour_refinement.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "services/map_builder/core/scan_tracker.hpp"
#include "tests/services/map_builder/ring.hpp"

namespace tandem {
namespace {

class NeighbourRefinement : public testing::Test {
 protected:
  /// The tracked ring, with its nodes then moved about by 5 cm.
  void SetUp() override {
    for (std::size_t i = 0; i < drive_.scans.size(); ++i) (void)tracker_.add(i, drive_.scans[i], graph_);
    Rng rng{3};
    for (std::size_t i = 1; i < graph_.poses.size(); ++i) {
      graph_.poses[i] = graph_.poses[i] * Pose2{rng.normal(0, 0.05), rng.normal(0, 0.05), rng.normal(0, 0.02)};
    }
  }
  /// Mean error of the motion from each node to the next [m].
  [[nodiscard]] double step_error_m() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < graph_.nodes.size(); ++i) {
      const Pose2 truth = inverse(ring_.truth[graph_.nodes[i - 1].scan]) * ring_.truth[graph_.nodes[i].scan];
      sum += (inverse(truth) * (inverse(graph_.poses[i - 1]) * graph_.poses[i])).position().norm();
    }
    return sum / static_cast<double>(graph_.nodes.size() - 1);
  }

  MapBuilderConfig config_;
  test::RingDrive ring_ = test::drive_around(10.0, 0.0);
  Drive drive_ = test::recorded(ring_, config_);
  ScanTracker tracker_{config_};
  MapGraph graph_;
};

TEST_F(NeighbourRefinement, BringsPosesBackToWhereScansAgree) {
  EXPECT_GT(step_error_m(), 0.05);
  RefinementState state;
  while (!is_refined(state, config_)) refine_neighbours(state, graph_, drive_, config_);
  EXPECT_EQ(refined_share(state, graph_, config_), 1.0);
  EXPECT_LT(step_error_m(), 0.02);
}

TEST_F(NeighbourRefinement, LeavesThePosesUntilTheFirstRoundIsWhole) {
  const auto before = graph_.poses;
  RefinementState state;
  for (std::size_t node = 1; node < graph_.nodes.size(); ++node) {
    refine_neighbours(state, graph_, drive_, config_);
    EXPECT_EQ(graph_.poses, before);
    EXPECT_LT(refined_share(state, graph_, config_), 0.5);  // one of two rounds
  }
  EXPECT_FALSE(state.pairs.empty());
  refine_neighbours(state, graph_, drive_, config_);
  EXPECT_NE(graph_.poses, before);
  EXPECT_EQ(state.round, 1U);
  EXPECT_TRUE(state.pairs.empty());
}

}  // namespace
}  // namespace tandem
