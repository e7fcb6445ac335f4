#pragma once

#include <cstdint>

#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem::bench {

/// What a random world of family S7 is made of.
struct SrsWorldOptions {
  int least_sources = 5;
  int most_sources = 8;
  int most_agents = 3;
};

/// A random task on an open plane of 20 m: discs with pools of different size and pace, some without a limit, some for
/// one agent only, all three kinds of relations, walking costs, sometimes a hazard. Equal seed, equal task.
[[nodiscard]] TaskProblem random_srs_task(std::uint64_t seed, const SrsWorldOptions& options = {});

}  // namespace tandem::bench
