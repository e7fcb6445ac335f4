#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace tandem::tracking {

/// For each row the column it is given, so that as many rows as possible have one and the sum of their costs is the
/// least possible. A cost that is not finite forbids the pair.
///
/// Shortest augmenting paths (Jonker and Volgenant, Computing 38, 1987) on the square matrix padded with costs larger
/// than any sum of allowed ones.
[[nodiscard]] std::vector<std::optional<int>> best_assignment(const Eigen::MatrixXd& costs);

}  // namespace tandem::tracking
