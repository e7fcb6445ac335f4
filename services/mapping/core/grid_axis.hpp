#pragma once

#include <limits>

namespace tandem {

/// The walk of a straight line over a grid, along one of its axes: in which cell the ray is, and at which length
/// [cells] it enters the next one.
struct GridAxis {
  GridAxis(double start, double direction, int first_cell) : cell(first_cell) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    if (direction > 0.0) {
      step = 1;
      next = (first_cell + 1 - start) / direction;
      between = 1.0 / direction;
    } else if (direction < 0.0) {
      step = -1;
      next = (first_cell - start) / direction;
      between = -1.0 / direction;
    } else {
      next = kNever;
      between = kNever;
    }
  }
  void advance() {
    cell += step;
    next += between;
  }
  int cell;
  int step = 0;
  double next;     ///< [cells] from the start of the ray
  double between;  ///< [cells]
};

}  // namespace tandem
