#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "services/experiment/core/study/study_summary.hpp"

namespace tandem::experiment {

/// What makes a study that one and no other; how many episodes it has does not.
struct StudySettings {
  std::string scenario;       ///< its name
  std::string planner;        ///< its name, perhaps with options
  std::string human;          ///< kind of person
  std::uint64_t seed = 1;     ///< of the first episode; the next ones follow
  std::int64_t rollouts = 0;  ///< of each plan,
  double budget_ms = 0.0;     ///< unless it has so much time instead
  std::string config_hash;    ///< of scenario, map and the configs of the services

  friend bool operator==(const StudySettings&, const StudySettings&) = default;
};

/// The first line of the file of a study, without its end.
[[nodiscard]] std::string settings_line(const StudySettings& settings);

/// One episode as one line of JSON, without its end. Rounded: to 0.01 s and 0.01 m, shares to 0.0001.
[[nodiscard]] std::string episode_line(const EpisodeResult& episode);
/// The episode that episode_line() wrote; none if `line` is not one, such as half of one.
[[nodiscard]] std::optional<EpisodeResult> parse_episode_line(std::string_view line);

/// The study as JSON: settings, episodes, summary.
[[nodiscard]] std::string study_json(const StudySettings& settings, std::span<const EpisodeResult> episodes);
/// The episodes as CSV with a head line.
[[nodiscard]] std::string study_csv(std::span<const EpisodeResult> episodes);

}  // namespace tandem::experiment
