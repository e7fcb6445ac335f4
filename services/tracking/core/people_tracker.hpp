#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "services/common/time.hpp"
#include "services/tracking/core/leg_detection.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::tracking {

/// Position and velocity in the map with their covariance, at constant velocity (a Kalman filter's state).
struct Motion {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();  ///< x [m], y [m], and their rates [m/s]
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();

  [[nodiscard]] Eigen::Vector2d position() const { return mean.head<2>(); }
  [[nodiscard]] Eigen::Vector2d velocity() const { return mean.tail<2>(); }
  /// Standard deviation of the position along its worse direction [m].
  [[nodiscard]] double standard_deviation_m() const;
};

/// `motion` after `step_s` in which the velocity changed at random (white noise acceleration, `acceleration_mps2`).
[[nodiscard]] Motion predicted(const Motion& motion, double step_s, double acceleration_mps2);
/// Squared Mahalanobis distance of a sighting from the motion.
[[nodiscard]] double squared_distance(const Motion& motion, const Sighting& sighting);
/// `motion` corrected by a sighting of its position.
[[nodiscard]] Motion corrected(const Motion& motion, const Sighting& sighting);

/// Someone followed from scan to scan.
struct Track {
  std::uint32_t id = 0;
  Motion motion;  ///< At the time of the last scan.
  Time last_seen{};
  Time first_seen{};
  Eigen::Vector2d first_position_in_map{0.0, 0.0};
  std::int64_t hits = 0;
  bool confirmed = false;  ///< Seen often enough to be something.
  bool person = false;     ///< Confirmed, and shows both legs or walks.
};

/// Follows everybody whom the laser sees: one Kalman filter each, sightings given out by the best assignment.
class PeopleTracker {
 public:
  explicit PeopleTracker(const TrackingConfig& config) : config_(config) {}

  /// Takes in the sightings of the scan of `time`; times must not go back.
  void update(Time time, const std::vector<Sighting>& sightings);
  [[nodiscard]] const std::vector<Track>& tracks() const { return tracks_; }
  /// The confirmed track `id`; null if it has ended.
  [[nodiscard]] const Track* find(std::uint32_t id) const;

 private:
  [[nodiscard]] std::vector<bool> give_out(Time time, const std::vector<Sighting>& sightings);
  void begin_tracks(Time time, const std::vector<Sighting>& sightings, const std::vector<bool>& given);

  TrackingConfig config_;
  std::vector<Track> tracks_;
  Time time_{};
  std::uint32_t next_id_ = 1;
};

}  // namespace tandem::tracking
