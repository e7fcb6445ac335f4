#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"

namespace tandem {

/// What an edge was measured with.
enum class EdgeKind { Odometry, Scan, Closure };

/// A measured motion from one pose of a graph to another.
struct PoseEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 from_pose_to_pose;
  Eigen::Matrix3d root_information = Eigen::Matrix3d::Identity();  ///< S, with S^T S the information in frame `from`
  EdgeKind kind = EdgeKind::Scan;
  double loss = 0.0;  ///< Off by more of its deviations than this, it counts less and less (Cauchy); 0: always fully.
};

/// A root of the information about a motion of b in b's own frame, as an edge from a to b holds it in a's frame.
[[nodiscard]] Eigen::Matrix3d root_information_in_a(const Pose2& a_from_b, const Eigen::Matrix3d& information_in_b);

/// How many deviations an edge is off: the length of its residual.
[[nodiscard]] double deviations_off(const PoseEdge& edge, std::span<const Pose2> poses);

/// Moves `poses`, the first excepted, to where the edges agree best (Ceres, sparse; one thread, so that equal input
/// gives equal output). Without `robust` every edge counts fully: so a true edge can pull from far away.
enum class Weighting { Full, Robust };
void optimise(std::vector<Pose2>& poses, std::span<const PoseEdge> edges, Weighting weighting, int most_iterations);

}  // namespace tandem
