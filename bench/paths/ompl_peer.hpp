#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/paths/path_case.hpp"

namespace tandem::bench {

/// The planners of OMPL that are compared.
[[nodiscard]] const std::vector<std::string>& ompl_planners();

/// Runs `program` (bench/paths/ompl) on a case: how good the way of `planner` is after each of the budgets, which
/// ascend [ms]. Throws std::runtime_error if the program fails.
[[nodiscard]] std::vector<PathRecord> ompl_ways(const std::filesystem::path& program, const PathCase& one,
                                                const std::string& planner, const std::vector<double>& budgets_ms);

/// What the program reads: size and resolution, rows of `.` and `#` from the lowest on, start and goal.
[[nodiscard]] std::string ompl_question(const PathCase& one);

/// The records in what the program writes: a line `BUDGET_MS LENGTH_M` for each budget. Throws std::runtime_error.
[[nodiscard]] std::vector<PathRecord> ompl_answer(const std::string& text, const PathCase& one,
                                                  const std::string& planner, const std::vector<double>& budgets_ms);

}  // namespace tandem::bench
