#include "calibration/core/wheel_motion.hpp"

#include <algorithm>
#include <span>

namespace tandem {
namespace {

constexpr double kLikeSpan = 3.0;  ///< A neighbouring step that took so much longer or shorter tells no rate.

Arc<double> sum(double a, const Arc<double>& first, double b, const Arc<double>& second) {
  return {a * first.forward_m + b * second.forward_m, a * first.left_m + b * second.left_m,
          a * first.turn_rad + b * second.turn_rad};
}

/// The steps between the samples of an odometry.
class Steps {
 public:
  explicit Steps(std::span<const OdometrySample> samples) : samples_(samples) {}

  /// Is there an unbroken step from sample `i` on?
  [[nodiscard]] bool has(std::size_t i) const {
    return i + 1 < samples_.size() && samples_[i].epoch == samples_[i + 1].epoch && seconds(i) > 0.0;
  }
  [[nodiscard]] double seconds(std::size_t i) const { return to_seconds(samples_[i + 1].time - samples_[i].time); }
  [[nodiscard]] Arc<double> arc(std::size_t i) const {
    return arc_to(inverse(samples_[i].odom_from_base) * samples_[i + 1].odom_from_base);
  }
  /// The rate at the sample between step `i` and its neighbour: that of both together.
  [[nodiscard]] Arc<double> rate_towards(std::size_t i, std::size_t neighbour) const {
    const double own = seconds(i);
    const bool alike = has(neighbour) && seconds(neighbour) < kLikeSpan * own && own < kLikeSpan * seconds(neighbour);
    if (!alike) return sum(1.0 / own, arc(i), 0.0, {});
    const double all = own + seconds(neighbour);
    // The rates at the middle of both, taken at the sample between.
    return sum(seconds(neighbour) / (all * own), arc(i), own / (all * seconds(neighbour)), arc(neighbour));
  }

 private:
  std::span<const OdometrySample> samples_;
};

/// Where the wheels are at one time.
struct Place {
  Pose2 odom_from_base;
  Arc<double> rate;
  int epoch = 0;
};

/// A cubic through the samples around: between two samples a robot that speeds up is not where a straight line has it.
std::optional<Place> place_at(std::span<const OdometrySample> samples, Time time) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), time,
                                      [](Time wanted, const OdometrySample& one) { return wanted < one.time; });
  if (after == samples.begin()) return std::nullopt;
  auto i = static_cast<std::size_t>(after - samples.begin()) - 1;
  if (i + 1 == samples.size() && samples[i].time == time && i > 0) --i;
  const Steps steps{samples};
  if (!steps.has(i)) return std::nullopt;
  const double span = steps.seconds(i);
  const double s = to_seconds(time - samples[i].time) / span;
  const Arc<double> step = steps.arc(i);
  const Arc<double> start = steps.rate_towards(i, i - 1);
  const Arc<double> end = steps.rate_towards(i, i + 1);
  const Arc<double> way =
      sum(s * s * (3.0 - 2.0 * s), step, span, sum(s * (1.0 - s) * (1.0 - s), start, s * s * (s - 1.0), end));
  const Arc<double> rate =
      sum(6.0 * s * (1.0 - s) / span, step, 1.0, sum((1.0 - s) * (1.0 - 3.0 * s), start, s * (3.0 * s - 2.0), end));
  const Arc<double> chord = chord_of(way);
  return Place{samples[i].odom_from_base * Pose2{chord.forward_m, chord.left_m, chord.turn_rad}, rate,
               samples[i].epoch};
}

}  // namespace

std::optional<WheelMotion> wheel_motion(const OdometryTrack& odometry, Time from, Time to) {
  const auto samples = odometry.samples();
  const auto start = place_at(samples, from);
  const auto end = place_at(samples, to);
  if (!start || !end || start->epoch != end->epoch) return std::nullopt;
  auto sample = std::upper_bound(samples.begin(), samples.end(), from,
                                 [](Time wanted, const OdometrySample& one) { return wanted < one.time; });
  WheelMotion motion{.steps = {}, .rate_at_start = start->rate, .rate_at_end = end->rate};
  Pose2 last = start->odom_from_base;
  for (; sample != samples.end() && sample->time < to; ++sample) {
    motion.steps.push_back(arc_to(inverse(last) * sample->odom_from_base));
    last = sample->odom_from_base;
  }
  motion.steps.push_back(arc_to(inverse(last) * end->odom_from_base));
  return motion;
}

}  // namespace tandem
