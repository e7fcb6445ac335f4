#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "services/cli/study/study_file.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::cli {

/// What a study plays.
struct StudyPlan {
  simulator::Scenario scenario;
  OccupancyGrid map;
  experiment::TeamOptions team;
  std::string human = "obedient";
  std::uint64_t seed = 1;  ///< of the first episode
  std::uint64_t episodes = 1;
  double budget_ms = 0.0;  ///< processor time of each plan; 0: as many rollouts as the planner's config says
  unsigned threads = 1;
  std::filesystem::path recordings = {};  ///< folder for a recording of each episode; empty: none
};

/// What the episode of `seed` is recorded as, in the folder of `plan.recordings`.
[[nodiscard]] std::filesystem::path study_recording(const StudyPlan& plan, std::uint64_t seed);

/// Plays the episodes of `plan` that `file` does not have yet, or whose recording is wanted and not there, and adds
/// each as it is finished.
///
/// `keep_going` hears the number of episodes that are there, at least ten times a second, and ends the run with false:
/// the episodes under way are given up.
void play_study(const StudyPlan& plan, StudyFile& file, const std::function<bool(std::uint64_t)>& keep_going);

}  // namespace tandem::cli
