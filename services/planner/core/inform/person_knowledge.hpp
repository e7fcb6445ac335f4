#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "services/planner/core/mission/watch.hpp"
#include "services/planner/core/search/belief_edit.hpp"

namespace tandem {

/// What a person is believed to know of the search (paper 3.4, (11)): the task, what they looked at, what they saw the
/// robot look at, what they said themselves, and what they took notice of when told.
class PersonKnowledge {
 public:
  /// They know as much as `belief` at first.
  PersonKnowledge(SearchBelief belief, const Watch& robot, const Watch& person)
      : belief_(std::move(belief)), robot_(robot), person_(person) {}

  void person_looks(Time stamp, const Pose2& map_from_person, Observability& observability);
  /// Nobody knows where the person is.
  void person_is_lost();
  /// Counts only while the person has the robot in sight.
  void robot_looks(Time stamp, const Pose2& map_from_robot, Observability& observability);
  /// They have said it themselves.
  void says(const BeliefEdit& edit, const SearchArea& area, std::size_t agent);
  /// They have taken notice of where the object may be.
  void learns(const SearchBelief& truth) { belief_ = truth; }
  /// They know of this source.
  void learns(const std::string& source_id) { sources_.insert(source_id); }
  /// The source is gone.
  void forgets(const std::string& source_id) { sources_.erase(source_id); }

  [[nodiscard]] const SearchBelief& belief() const { return belief_; }
  [[nodiscard]] bool knows(const std::string& source_id) const { return sources_.contains(source_id); }

 private:
  SearchBelief belief_;
  Watch robot_;
  Watch person_;
  std::optional<Pose2> map_from_person_;  ///< none while nobody knows
  std::set<std::string> sources_;
};

}  // namespace tandem
