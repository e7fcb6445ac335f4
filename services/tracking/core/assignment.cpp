#include "services/tracking/core/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::tracking {

std::vector<std::optional<int>> best_assignment(const Eigen::MatrixXd& costs) {
  const auto rows = static_cast<int>(costs.rows());
  const auto columns = static_cast<int>(costs.cols());
  const int size = std::max(rows, columns);
  double forbidden = 1.0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      if (std::isfinite(costs(r, c))) forbidden += std::abs(costs(r, c));
    }
  }
  const auto cost = [&](int r, int c) {
    return r < rows && c < columns && std::isfinite(costs(r, c)) ? costs(r, c) : forbidden;
  };

  // Potentials of rows and columns; `row_of[c]` is the row column c is given to. Index 0 is a sentinel.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto n = static_cast<std::size_t>(size) + 1;
  std::vector<double> row_potential(n, 0.0);
  std::vector<double> column_potential(n, 0.0);
  std::vector<int> row_of(n, 0);
  for (int r = 1; r <= size; ++r) {
    std::vector<double> least(n, kInfinity);
    std::vector<int> before(n, 0);
    std::vector<bool> reached(n, false);
    row_of[0] = r;
    int column = 0;
    do {
      reached[column] = true;
      const int row = row_of[column];
      double step = kInfinity;
      int next = 0;
      for (int c = 1; c <= size; ++c) {
        if (reached[c]) continue;
        const double reduced = cost(row - 1, c - 1) - row_potential[row] - column_potential[c];
        if (reduced < least[c]) {
          least[c] = reduced;
          before[c] = column;
        }
        if (least[c] < step) {
          step = least[c];
          next = c;
        }
      }
      for (int c = 0; c <= size; ++c) {
        if (reached[c]) {
          row_potential[row_of[c]] += step;
          column_potential[c] -= step;
        } else {
          least[c] -= step;
        }
      }
      column = next;
    } while (row_of[column] != 0);
    while (column != 0) {
      const int previous = before[column];
      row_of[column] = row_of[previous];
      column = previous;
    }
  }

  std::vector<std::optional<int>> column_of(static_cast<std::size_t>(rows));
  for (int c = 1; c <= columns; ++c) {
    const int r = row_of[c] - 1;
    if (r >= 0 && r < rows && std::isfinite(costs(r, c - 1))) column_of[r] = c - 1;
  }
  return column_of;
}

}  // namespace tandem::tracking
