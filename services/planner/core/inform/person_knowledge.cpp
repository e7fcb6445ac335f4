#include "services/planner/core/inform/person_knowledge.hpp"

#include <algorithm>

namespace tandem {

void PersonKnowledge::person_looks(Time stamp, const Pose2& map_from_person, Observability& observability) {
  map_from_person_ = map_from_person;
  person_.look(stamp, map_from_person, observability, belief_);
}

void PersonKnowledge::person_is_lost() {
  map_from_person_.reset();
  person_.pause();
}

void PersonKnowledge::robot_looks(Time stamp, const Pose2& map_from_robot, Observability& observability) {
  const SearchArea& area = observability.area();
  const auto robots_cell = area.cell_at(map_from_robot.position());
  const auto own_cell = map_from_person_ ? area.cell_at(map_from_person_->position()) : std::nullopt;
  if (robots_cell && own_cell && std::ranges::binary_search(observability.in_sight_of(*own_cell), *robots_cell)) {
    robot_.look(stamp, map_from_robot, observability, belief_);
  } else {
    robot_.pause();
  }
}

void PersonKnowledge::says(const BeliefEdit& edit, const SearchArea& area, std::size_t agent) {
  (void)edit_belief(belief_, area, edit, agent);  // what is to be refused was refused for the true belief
}

}  // namespace tandem
