#include "services/planner/core/tasks/task_sequences.hpp"

#include <algorithm>

namespace tandem {
namespace {

using Sequence = std::vector<TaskAction>;

constexpr double kShareWaits = 0.3;       ///< of what is added
constexpr std::size_t kLongestBlock = 3;  ///< of actions that go elsewhere together

/// Any action of any agent; none if there is none.
std::pair<Sequence*, std::size_t> any_action(TaskSequences& sequences, Rng& rng) {
  std::size_t count = 0;
  for (const Sequence& one : sequences) count += one.size();
  if (count == 0) return {nullptr, 0};
  std::size_t chosen = rng.index(count);
  for (Sequence& one : sequences) {
    if (chosen < one.size()) return {&one, chosen};
    chosen -= one.size();
  }
  return {nullptr, 0};
}

void insert_anywhere(TaskSequences& sequences, const TaskAction& action, Rng& rng) {
  Sequence& sequence = sequences[rng.index(sequences.size())];
  const auto at = static_cast<std::ptrdiff_t>(rng.index(sequence.size() + 1));
  sequence.insert(sequence.begin() + at, action);
}

/// Actions that follow each other go elsewhere together.
void move_block(TaskSequences& sequences, Sequence& from, std::size_t at, std::size_t length, Rng& rng) {
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(at);
  const auto end = begin + static_cast<std::ptrdiff_t>(std::min(length, from.size() - at));
  const Sequence block(begin, end);
  from.erase(begin, end);
  Sequence& to = sequences[rng.index(sequences.size())];
  to.insert(to.begin() + static_cast<std::ptrdiff_t>(rng.index(to.size() + 1)), block.begin(), block.end());
}

void change_once(TaskSequences& sequences, std::size_t sources, Rng& rng) {
  const std::size_t kind = rng.index(6);
  const auto [sequence, at] = any_action(sequences, rng);
  if (sequence == nullptr || kind == 0) {
    TaskAction added;  // a wait
    if (rng.uniform() >= kShareWaits) {
      added.kind = TaskActionKind::Visit;
      added.source = static_cast<std::int16_t>(rng.index(sources));
    }
    insert_anywhere(sequences, added, rng);
    return;
  }
  if (kind == 1) {
    TaskAction& same = (*sequence)[at];
    same.until = static_cast<StayEnd>(rng.index(3));
    same.next = same.until == StayEnd::InTimeFor ? static_cast<std::int16_t>(rng.index(sources)) : std::int16_t{-1};
  } else if (kind == 2) {
    sequence->erase(sequence->begin() + static_cast<std::ptrdiff_t>(at));
  } else if (kind == 3) {
    const auto [other, other_at] = any_action(sequences, rng);
    std::swap((*sequence)[at], (*other)[other_at]);
  } else {
    move_block(sequences, *sequence, at, kind == 4 ? 1 : 1 + rng.index(kLongestBlock), rng);
  }
}

}  // namespace

TaskSequences sequences_of(const std::vector<TaskAction>& decisions, std::size_t agents) {
  TaskSequences sequences(agents);
  for (const TaskAction& action : decisions) {
    if (action.agent >= 0) sequences[static_cast<std::size_t>(action.agent)].push_back(action);
  }
  return sequences;
}

void change(TaskSequences& sequences, std::size_t sources, Rng& rng) {
  for (std::size_t times = 1 + rng.index(3); times > 0; --times) change_once(sequences, sources, rng);
}

int following(const Sequence& sequence, std::size_t& next, const std::vector<TaskAction>& actions) {
  while (next < sequence.size()) {
    const TaskAction& wanted = sequence[next++];
    int nearly = -1;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const TaskAction& action = actions[i];
      if (action.kind != wanted.kind || action.source != wanted.source) continue;
      if (nearly < 0) nearly = static_cast<int>(i);
      const bool is_same_place = wanted.place < 0 || action.place != wanted.place || action.way == wanted.way;
      if (action.until == wanted.until && action.next == wanted.next && is_same_place) return static_cast<int>(i);
    }
    if (nearly >= 0) return nearly;
  }
  return -1;
}

}  // namespace tandem
