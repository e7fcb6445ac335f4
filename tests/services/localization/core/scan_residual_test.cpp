#include "services/localization/core/scan_residual.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

template <int Size>
void expect_derivatives_as_differences(const ceres::CostFunction& residual, const double* pose, double tolerance) {
  double values[Size];
  double jacobian[Size * 3];
  double* jacobians[] = {jacobian};
  ASSERT_TRUE(residual.Evaluate(&pose, values, jacobians));
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 3; ++k) {
    double before[3] = {pose[0], pose[1], pose[2]};
    double after[3] = {pose[0], pose[1], pose[2]};
    before[k] -= kStep;
    after[k] += kStep;
    const double* before_pointer = before;
    const double* after_pointer = after;
    double low[Size];
    double high[Size];
    residual.Evaluate(&before_pointer, low, nullptr);
    residual.Evaluate(&after_pointer, high, nullptr);
    for (int i = 0; i < Size; ++i) {
      ASSERT_NEAR(jacobian[i * 3 + k], (high[i] - low[i]) / (2.0 * kStep), tolerance) << "row " << i << " column " << k;
    }
  }
}

TEST(ScanResidual, IsTheDistanceFromTheEndOfTheBeamToTheWall) {
  const DistanceField field{test::ascii_map({"......#"})};
  const ScanResidual residual{field, {2.0, 0.0}};
  const double pose[3] = {1.5, 0.5, 0.0};
  const double* parameters = pose;
  double distance = 0.0;

  residual.Evaluate(&parameters, &distance, nullptr);

  EXPECT_NEAR(distance, 3.0, 1e-6);  // from 3.5 to the wall's centre at 6.5
}

TEST(ScanResidual, HasTheDerivativesThatDifferencesHave) {
  Rng rng{17};
  OccupancyGrid grid{60, 60, 0.1, {-2.0, 1.0, 0.4}, CellState::Free};
  for (CellState& cell : grid.cells()) {
    if (rng.uniform() < 0.02) cell = CellState::Occupied;
  }
  const DistanceField field{grid, 2.0};
  for (int i = 0; i < 300; ++i) {
    const ScanResidual residual{field, {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}};
    const Eigen::Vector2d p = grid.map_from_grid() * Eigen::Vector2d{rng.uniform(2.0, 4.0), rng.uniform(2.0, 4.0)};
    const double pose[3] = {p.x(), p.y(), rng.uniform(-3.0, 3.0)};
    expect_derivatives_as_differences<1>(residual, pose, 1e-4);
  }
}

TEST(PriorResidual, HasTheDerivativesThatDifferencesHave) {
  Rng rng{18};
  for (int i = 0; i < 100; ++i) {
    const PriorResidual residual{{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-3, 3)}, 2.0, 3.0};
    const double pose[3] = {rng.uniform(-5, 5), rng.uniform(-5, 5), 0.0};
    expect_derivatives_as_differences<3>(residual, pose, 1e-6);
  }
}

}  // namespace
}  // namespace tandem
