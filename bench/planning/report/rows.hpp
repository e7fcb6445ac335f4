#pragma once

#include <string>
#include <vector>

#include "bench/planning/report/results.hpp"

namespace tandem::bench {

enum class Verdict { Met, NotMet, NotMeasured };

/// One claim of a target, and what was measured.
struct TargetLine {
  int row = 0;
  std::string target;
  std::string measured;
  Verdict verdict = Verdict::NotMeasured;
};

/// The targets of planning and search, rows 1 to 12, against `results`. Closed loops count at `budget`.
[[nodiscard]] std::vector<TargetLine> target_lines(const Results& results, const std::string& budget);

}  // namespace tandem::bench
