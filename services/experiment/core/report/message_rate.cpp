#include "services/experiment/core/report/message_rate.hpp"

#include <algorithm>
#include <cmath>

#include "services/experiment/core/report/statistics.hpp"

namespace tandem::experiment {

std::vector<double> times_between_messages(const EpisodeLog& episode, std::string_view kind, double until_s) {
  std::vector<double> times;
  double before_s = 0.0;
  for (const PressAt& press : episode.presses) {
    if (press.kind != kind) continue;
    if (press.time_s > until_s) break;
    if (press.time_s > 0.0) times.push_back(press.time_s - before_s);
    before_s = press.time_s;
  }
  return times;
}

MessageRate message_rate(std::span<const EpisodeLog* const> episodes, std::string_view kind, double until_s,
                         double threshold_s) {
  constexpr double kPerMinute = 60.0;
  std::vector<double> rates;
  std::vector<double> shares;
  for (const EpisodeLog* episode : episodes) {
    const double length_s = std::min(episode->duration_s, until_s);
    if (!(length_s > 0.0)) continue;
    const auto times = times_between_messages(*episode, kind, length_s);
    rates.push_back(kPerMinute * static_cast<double>(times.size()) / length_s);
    if (!times.empty()) shares.push_back(share_within(times, threshold_s));
  }
  return {.episodes = rates.size(),
          .per_min = mean_of(rates),
          .per_min_deviation = deviation_of(rates),
          .within = mean_of(shares),
          .with_messages = shares.size()};
}

double matching_threshold_s(std::span<const double> times_between_s, double share) {
  if (times_between_s.empty()) return 0.0;
  std::vector<double> sorted(times_between_s.begin(), times_between_s.end());
  std::ranges::sort(sorted);
  const auto needed = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()) - 1e-9));
  return sorted[std::clamp<std::size_t>(needed, 1, sorted.size()) - 1];
}

double share_within(std::span<const double> times_between_s, double threshold_s) {
  if (times_between_s.empty()) return 0.0;
  const auto within = std::ranges::count_if(times_between_s, [&](double time_s) { return time_s <= threshold_s; });
  return static_cast<double>(within) / static_cast<double>(times_between_s.size());
}

}  // namespace tandem::experiment
