#pragma once

#include <span>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"

namespace tandem::experiment {

/// The newest belief that there was at `time_s`; null before the first.
[[nodiscard]] const BeliefAt* belief_at(const EpisodeLog& episode, double time_s);

/// How much of the searched area had been seen.
struct ExploredAt {
  double time_s = 0.0;
  double by_robot = 0.0;  ///< [0, 1] the robot was first to see
  double by_all = 0.0;    ///< [0, 1]
};

/// As belief_at() says; nothing seen before the first.
[[nodiscard]] ExploredAt explored_at(const EpisodeLog& episode, double time_s);

/// An episode's progress as a line: one point each `step_s` and one at its end.
[[nodiscard]] std::vector<ExploredAt> explored_line(const EpisodeLog& episode, double step_s);

/// Progress over many episodes at one moment (paper 8.4.3, Fig. 22).
struct MeanExploredAt {
  double time_s = 0.0;
  std::size_t ongoing = 0;  ///< episodes that have not ended: those the means are of
  double by_robot = 0.0;
  double by_all = 0.0;
};
/// At 0, `step_s`, ... until the last episode has ended.
[[nodiscard]] std::vector<MeanExploredAt> mean_explored(std::span<const EpisodeLog* const> episodes, double step_s);

}  // namespace tandem::experiment
