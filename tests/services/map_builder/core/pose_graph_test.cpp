#include "services/map_builder/core/pose_graph.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

/// A square of sides of 4 m, counter-clockwise, back to the start: the last pose is the first.
std::vector<PoseEdge> square_walk() {
  const Pose2 side{4.0, 0.0, std::numbers::pi / 2.0};
  std::vector<PoseEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    edges.push_back(
        {.from = i, .to = i + 1, .from_pose_to_pose = side, .root_information = Eigen::Matrix3d::Identity()});
  }
  return edges;
}

std::vector<Pose2> guessed_square() {
  return {{0, 0, 0}, {4.3, 0.2, 1.5}, {4.2, 4.4, 3.0}, {-0.4, 3.8, -1.7}, {0.5, 0.6, 0.2}};
}

TEST(PoseGraph, LaysPosesWhereTheEdgesSay) {
  std::vector<Pose2> poses = guessed_square();
  optimise(poses, square_walk(), Weighting::Full, 50);
  EXPECT_EQ(poses[0], (Pose2{}));  // the first stays
  EXPECT_NEAR((poses[2].position() - Eigen::Vector2d{4.0, 4.0}).norm(), 0.0, 1e-4);
  EXPECT_NEAR(poses[4].position().norm(), 0.0, 1e-4);
}

TEST(PoseGraph, SpreadsAnErrorOverTheLoop) {
  std::vector<PoseEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    edges.push_back({.from = i, .to = i + 1, .from_pose_to_pose = {1.0, 0.0, 0.0}});
  }
  edges.push_back({.from = 0, .to = 4, .from_pose_to_pose = {4.5, 0.0, 0.0}});
  std::vector<Pose2> poses{{}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  optimise(poses, edges, Weighting::Full, 50);
  EXPECT_NEAR(poses[4].x, 4.4, 1e-3);  // five equal edges share 0.5 m
  EXPECT_NEAR(deviations_off(edges[4], poses), 0.1, 1e-3);
}

TEST(PoseGraph, IsNotBentByAClosureThatIsFalse) {
  std::vector<PoseEdge> edges = square_walk();
  for (PoseEdge& edge : edges) edge.root_information *= 20.0;
  edges.push_back(
      {.from = 0, .to = 4, .from_pose_to_pose = {}, .root_information = 20.0 * Eigen::Matrix3d::Identity()});
  edges.push_back({.from = 0,
                   .to = 2,
                   .from_pose_to_pose = {0.0, 0.0, 0.0},
                   .root_information = 20.0 * Eigen::Matrix3d::Identity(),
                   .kind = EdgeKind::Closure,
                   .loss = 1.0});
  std::vector<Pose2> poses = guessed_square();
  optimise(poses, edges, Weighting::Robust, 100);
  EXPECT_LT((poses[2].position() - Eigen::Vector2d{4.0, 4.0}).norm(), 0.1);
  EXPECT_GT(deviations_off(edges.back(), poses), 50.0);
}

TEST(PoseGraph, TurnsWithTheWorld) {
  std::vector<PoseEdge> edges = square_walk();
  edges.push_back({.from = 0, .to = 3, .from_pose_to_pose = {0.2, 4.1, -1.5}});
  std::vector<Pose2> here = guessed_square();
  const Pose2 world{10.0, -3.0, 2.5};
  std::vector<Pose2> there;
  for (const Pose2& pose : here) there.push_back(world * pose);
  optimise(here, edges, Weighting::Full, 50);
  optimise(there, edges, Weighting::Full, 50);
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_LT(((world * here[i]).position() - there[i].position()).norm(), 1e-4) << i;
  }
}

TEST(PoseGraph, LeavesPosesThatNothingHolds) {
  std::vector<Pose2> poses{{1, 2, 3}, {4, 5, 0.5}};
  optimise(poses, {}, Weighting::Full, 10);
  EXPECT_EQ(poses[1], (Pose2{4, 5, 0.5}));
}

TEST(PoseGraph, TurnsAnInformationIntoTheFrameOfTheFirstPose) {
  // b looks along a's y axis: what is exact along b's x is exact along a's y.
  const Eigen::Matrix3d in_b = Eigen::Vector3d{100.0, 1.0, 4.0}.asDiagonal();
  const Eigen::Matrix3d root = root_information_in_a({0.0, 0.0, std::numbers::pi / 2.0}, in_b);
  const Eigen::Matrix3d in_a = root.transpose() * root;
  EXPECT_NEAR(in_a(0, 0), 1.0, 1e-4);
  EXPECT_NEAR(in_a(1, 1), 100.0, 1e-4);
  EXPECT_NEAR(in_a(2, 2), 4.0, 1e-4);
}

TEST(PoseGraph, HasARootOfNoInformation) {
  EXPECT_TRUE(root_information_in_a({}, Eigen::Matrix3d::Zero()).allFinite());
}

}  // namespace
}  // namespace tandem
