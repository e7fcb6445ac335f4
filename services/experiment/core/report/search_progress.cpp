#include "services/experiment/core/report/search_progress.hpp"

#include <algorithm>

namespace tandem::experiment {

namespace {

/// Seconds of stamps are not exact: what is this much later is of the same time.
constexpr double kStampRounding_s = 1e-6;

}  // namespace

const BeliefAt* belief_at(const EpisodeLog& episode, double time_s) {
  const auto next = std::ranges::upper_bound(episode.beliefs, time_s + kStampRounding_s, {}, &BeliefAt::time_s);
  return next == episode.beliefs.begin() ? nullptr : &*(next - 1);
}

ExploredAt explored_at(const EpisodeLog& episode, double time_s) {
  const BeliefAt* belief = belief_at(episode, time_s);
  if (belief == nullptr) return {.time_s = time_s};
  return {.time_s = time_s, .by_robot = belief->explored_robot, .by_all = belief->explored};
}

std::vector<ExploredAt> explored_line(const EpisodeLog& episode, double step_s) {
  std::vector<ExploredAt> line;
  for (int i = 0; i * step_s < episode.duration_s; ++i) line.push_back(explored_at(episode, i * step_s));
  line.push_back(explored_at(episode, episode.duration_s));
  return line;
}

std::vector<MeanExploredAt> mean_explored(std::span<const EpisodeLog* const> episodes, double step_s) {
  double last_s = 0.0;
  for (const EpisodeLog* episode : episodes) last_s = std::max(last_s, episode->duration_s);
  std::vector<MeanExploredAt> means;
  for (int i = 0; i * step_s < last_s; ++i) {
    MeanExploredAt mean{.time_s = i * step_s};
    for (const EpisodeLog* episode : episodes) {
      if (mean.time_s >= episode->duration_s) continue;
      const ExploredAt explored = explored_at(*episode, mean.time_s);
      ++mean.ongoing;
      mean.by_robot += explored.by_robot;
      mean.by_all += explored.by_all;
    }
    mean.by_robot /= static_cast<double>(mean.ongoing);
    mean.by_all /= static_cast<double>(mean.ongoing);
    means.push_back(mean);
  }
  return means;
}

}  // namespace tandem::experiment
