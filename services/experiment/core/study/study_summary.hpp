#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "services/experiment/core/episode/episode.hpp"

namespace tandem::experiment {

/// A mean and where it lies with 95 % confidence.
struct MeanWithInterval {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The mean of `values` and its bootstrap interval (percentiles of 10,000 resamples); all 0 without values.
[[nodiscard]] MeanWithInterval mean_with_interval(std::span<const double> values);

/// A study in numbers.
struct StudySummary {
  std::size_t episodes = 0;
  std::size_t found = 0;
  MeanWithInterval time_s;                         ///< An episode without a find counts with its limit.
  double explored_at_find = 0.0;                   ///< Mean over the episodes with a find.
  double explored_robot = 0.0;                     ///< Likewise, seen first by the robot,
  double explored_human = 0.0;                     ///< and by the person.
  double stops = 0.0;                              ///< Per episode.
  double near_collisions = 0.0;                    ///< Per episode.
  int collisions = 0;                              ///< In all.
  double longest_idle_s = 0.0;                     ///< Of the robot, in all.
  std::map<std::string, double> messages_per_min;  ///< By kind.
  std::map<std::string, double> role_shares;       ///< Of the time with a plan, by role.
};

[[nodiscard]] StudySummary summary_of(std::span<const EpisodeResult> episodes);

}  // namespace tandem::experiment
