#pragma once

#include <span>
#include <string>

#include "services/experiment/core/report/report.hpp"

namespace tandem::experiment {

/// What goes into the page of a report beside its numbers.
struct PageOptions {
  std::string title = {};
  bool with_replay = true;     ///< the data of the scrubber: map, ways, plans, beliefs
  double pose_step_s = 0.5;    ///< of ways in it
  double belief_step_s = 2.0;  ///< of beliefs in it
};

/// The data of the report's page as JSON; rounded to what can be seen.
[[nodiscard]] std::string report_json(std::span<const EpisodeLog> episodes, const Report& report,
                                      const PageOptions& options);

}  // namespace tandem::experiment
