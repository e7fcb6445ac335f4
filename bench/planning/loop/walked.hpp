#pragma once

#include <vector>

#include "services/planner/core/team/search_world.hpp"

namespace tandem::bench {

/// The part of `path` from `from_s` to `to_s`, its times counted from `from_s`. Who is at the end of the path stays
/// there. The path must not be empty.
[[nodiscard]] TimedPath cut(const TimedPath& path, double from_s, double to_s);

/// Where one is at the end of `walked`: looking where it went last, or as in `before` if it did not move.
[[nodiscard]] Pose2 pose_after(const TimedPath& walked, const Pose2& before);

/// What one searcher has done since the search began, to the letter.
struct Walked {
  Pose2 start;
  TimedPath path;  ///< from the beginning of the search
};

/// Appends `piece`, which begins where and when `walked` ends.
void append(Walked& walked, const TimedPath& piece);

/// What is left of `mass` after one saw `seen` with `rate_per_s`, until `end_s`.
void take_off_seen(std::vector<double>& mass, const Sightings& seen, double rate_per_s, double end_s);

[[nodiscard]] double length_m(const TimedPath& path);

/// How far two paths over the same time lie apart: their discrete Fréchet distance, sampled every `step_s` [m].
[[nodiscard]] double frechet_distance_m(const TimedPath& a, const TimedPath& b, double duration_s, double step_s = 1.0);

}  // namespace tandem::bench
