#pragma once

#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/tasks/task_state.hpp"

namespace tandem {

/// What each agent does, one thing after the other, whatever the others do: a joint plan without its times.
using TaskSequences = std::vector<std::vector<TaskAction>>;

/// The sequences of a chain of decisions of so many agents.
[[nodiscard]] TaskSequences sequences_of(const std::vector<TaskAction>& decisions, std::size_t agents);

/// Changes one to three things at random: moves some actions to another place or agent, swaps two, drops one, adds a
/// visit of one of so many sources or a wait, or lets a stay end otherwise.
void change(TaskSequences& sequences, std::size_t sources, Rng& rng);

/// Which of `actions`, what an agent can do now, goes on with its sequence from `next` on: the first action of the
/// sequence that is possible, with the same end of the stay if there is such a one. Moves `next` behind it. -1 if
/// nothing of the sequence is possible any more.
[[nodiscard]] int following(const std::vector<TaskAction>& sequence, std::size_t& next,
                            const std::vector<TaskAction>& actions);

}  // namespace tandem
