#include "services/experiment/core/study/study_summary.hpp"

#include <algorithm>

#include "services/common/random.hpp"
#include "services/experiment/core/report/statistics.hpp"

namespace tandem::experiment {
namespace {

constexpr int kResamples = 10'000;
constexpr std::uint64_t kResamplingSeed = 1;

}  // namespace

MeanWithInterval mean_with_interval(std::span<const double> values) {
  if (values.empty()) return {};
  Rng rng{kResamplingSeed};
  std::vector<double> means;
  means.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) sum += values[rng.index(values.size())];
    means.push_back(sum / static_cast<double>(values.size()));
  }
  std::ranges::sort(means);
  return {mean_of(values), means[kResamples / 40], means[kResamples - 1 - kResamples / 40]};
}

StudySummary summary_of(std::span<const EpisodeResult> episodes) {
  StudySummary summary;
  summary.episodes = episodes.size();
  if (episodes.empty()) return summary;
  std::vector<double> times_s;
  double time_s = 0.0;
  double role_time_s = 0.0;
  for (const EpisodeResult& episode : episodes) {
    times_s.push_back(episode.time_s);
    time_s += episode.time_s;
    if (episode.found) {
      ++summary.found;
      summary.explored_at_find += episode.explored;
      summary.explored_robot += episode.explored_robot;
      summary.explored_human += episode.explored_human;
    }
    summary.stops += episode.robot.stops;
    summary.near_collisions += episode.robot.near_collisions;
    summary.collisions += episode.robot.collisions;
    summary.longest_idle_s = std::max(summary.longest_idle_s, episode.robot.longest_idle_s);
    for (const auto& [kind, count] : episode.messages) summary.messages_per_min[kind] += count;
    for (std::size_t i = 0; i < episode.roles.size(); ++i) {
      const double until_s = i + 1 < episode.roles.size() ? episode.roles[i + 1].time_s : episode.time_s;
      summary.role_shares[name_of(episode.roles[i].role)] += until_s - episode.roles[i].time_s;
      role_time_s += until_s - episode.roles[i].time_s;
    }
  }
  summary.time_s = mean_with_interval(times_s);
  const auto found = static_cast<double>(std::max<std::size_t>(1, summary.found));
  summary.explored_at_find /= found;
  summary.explored_robot /= found;
  summary.explored_human /= found;
  summary.stops /= static_cast<double>(episodes.size());
  summary.near_collisions /= static_cast<double>(episodes.size());
  for (auto& [kind, count] : summary.messages_per_min) count = time_s > 0.0 ? 60.0 * count / time_s : 0.0;
  for (auto& [role, share] : summary.role_shares) share = role_time_s > 0.0 ? share / role_time_s : 0.0;
  return summary;
}

}  // namespace tandem::experiment
