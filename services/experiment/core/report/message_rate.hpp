#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"

namespace tandem::experiment {

/// The time from the message before to each message of `kind` that came in (0, until_s] [s].
///
/// The message before may lie before the search began: the paper's episodes begin with *My pose*. The first of all, if
/// it comes during the search, counts from the beginning.
[[nodiscard]] std::vector<double> times_between_messages(const EpisodeLog& episode, std::string_view kind,
                                                         double until_s);

/// How often a person said something, over the beginnings of many episodes (paper 8.4.1, Table 1).
struct MessageRate {
  std::size_t episodes = 0;        ///< that lasted longer than nothing
  double per_min = 0.0;            ///< mean over episodes
  double per_min_deviation = 0.0;  ///< standard deviation over episodes, of a sample
  double within = 0.0;             ///< mean share of messages that came within the threshold, over those that had any
  std::size_t with_messages = 0;   ///< episodes that had any
};

/// `until_s`: only what came by then counts, and shorter episodes with all they have; infinity: all.
/// `threshold_s`: of the time between messages; one of just that long is within.
[[nodiscard]] MessageRate message_rate(std::span<const EpisodeLog* const> episodes, std::string_view kind,
                                       double until_s, double threshold_s);

/// The smallest time between messages that at least `share` of them do not exceed; 0 without messages.
///
/// With it the thresholds of two groups of people are made alike (paper 8.4.2: 10 s of one are 8.32 s of the other).
[[nodiscard]] double matching_threshold_s(std::span<const double> times_between_s, double share);

/// The share of `times_between_s` that do not exceed `threshold_s`; 0 without any.
[[nodiscard]] double share_within(std::span<const double> times_between_s, double threshold_s);

}  // namespace tandem::experiment
