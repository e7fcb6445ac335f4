#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "services/planner/core/team/search_problem.hpp"

namespace tandem::remote {

/// docs/planner_protocol.md. Each message is one line, without the line's end.

/// What stays from plan to plan: maps and search cells.
[[nodiscard]] std::string world_message(SearchWorld& world);

/// What is to be planned now.
[[nodiscard]] std::string plan_message(const SearchProblem& problem, double budget_s, std::uint64_t seed);

/// The paths of an answer, checked: one for each member, from its pose (committed path first), no faster than the
/// member, through no wall. Throws RemotePlannerError.
[[nodiscard]] std::vector<TimedPath> paths_of_answer(std::string_view line, const SearchProblem& problem);

}  // namespace tandem::remote
