#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tandem::tracking {

/// Where a person truly is, or is thought to be, in one frame.
struct AnnotatedPerson {
  std::string id;
  Eigen::Vector2d position{0.0, 0.0};
};
struct FoundPerson {
  std::uint32_t id = 0;
  Eigen::Vector2d position{0.0, 0.0};
};

/// What a tracker's people are worth beside annotated ones, as in the CLEAR MOT metrics (Bernardin and Stiefelhagen,
/// 2008): within `gate_m` a track that had a person keeps them, the rest are given out by the least sum of distances.
class TrackScore {
 public:
  explicit TrackScore(double gate_m) : gate_m_(gate_m) {}

  /// One moment of which both are known; without annotations every track is false.
  void add(const std::vector<AnnotatedPerson>& annotated, const std::vector<FoundPerson>& found);

  [[nodiscard]] std::size_t moments() const { return moments_; }
  [[nodiscard]] std::size_t annotations() const { return annotations_; }
  /// Share of the annotations that a track was given to; none without annotations.
  [[nodiscard]] std::optional<double> recall() const;
  /// Median distance of the track from the person [m], over all that were found; none if nobody was.
  [[nodiscard]] std::optional<double> median_m() const;
  /// Tracks that are nobody, per moment.
  [[nodiscard]] double false_per_moment() const;
  /// How often a person was given another track than the one before.
  [[nodiscard]] std::size_t id_switches() const { return id_switches_; }

 private:
  double gate_m_;
  std::size_t moments_ = 0;
  std::size_t annotations_ = 0;
  std::size_t false_tracks_ = 0;
  std::size_t id_switches_ = 0;
  std::vector<double> distances_m_;
  std::map<std::string, std::uint32_t> track_of_;
};

/// The middle of `values`, none of nothing.
[[nodiscard]] std::optional<double> median_of(std::vector<double> values);

}  // namespace tandem::tracking
