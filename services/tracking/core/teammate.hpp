#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/tracking/core/people_tracker.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::tracking {

/// *My pose*: where the person says they were when they pressed.
struct PoseMessage {
  Time stamp{};
  Eigen::Vector2d point_in_map{0.0, 0.0};
  std::optional<double> heading;  ///< [rad]
};

enum class Source { Laser, Message, Predicted };

/// Where the teammate is, as far as it is known.
struct TeammateEstimate {
  Time stamp{};
  Pose2 map_from_agent;
  Eigen::Vector2d velocity_in_map_mps{0.0, 0.0};
  double standard_deviation_m = 0.0;
  double heading_deviation_rad = 0.0;
  Source source = Source::Predicted;
  bool lost = false;   ///< Neither seen nor heard of for too long.
  double age_s = 0.0;  ///< Since the last sighting or message.
};

/// Keeps one teammate apart from all the others: named by *My pose*, then followed by the laser, predicted between.
///
/// A message names the nearest track near its point, unless the track it had still fits: legs are more exact than
/// fingers. While no track is theirs, the person is thought to walk on as their plan says, else as they went; a single
/// new track where they can have got to is taken for them.
class Teammate {
 public:
  explicit Teammate(const TrackingConfig& config) : config_(config) {}

  /// A message that has just come in.
  void hear(const PoseMessage& message, const PeopleTracker& people);
  /// What the laser has made of the scan of `time`.
  void see(Time time, const PeopleTracker& people);
  /// The person's path of the accepted plan; empty if there is none.
  void follow(std::vector<Eigen::Vector2d> path_in_map) { path_in_map_ = std::move(path_in_map); }

  /// None before a message tied someone to the agent.
  [[nodiscard]] std::optional<TeammateEstimate> estimate(Time now) const;
  /// The track that is the teammate, while there is one.
  [[nodiscard]] std::optional<std::uint32_t> track_id() const { return track_id_; }

 private:
  /// The last thing known for sure.
  struct Evidence {
    Time stamp{};
    Eigen::Vector2d position_in_map{0.0, 0.0};
    Eigen::Vector2d velocity_in_map_mps{0.0, 0.0};
    double standard_deviation_m = 0.0;
    bool by_laser = false;
  };
  void take(const Track& track);
  void look_for_track(Time time, const PeopleTracker& people);

  TrackingConfig config_;
  std::optional<Evidence> evidence_;
  std::optional<double> heading_;  ///< as last walked or said
  std::optional<std::uint32_t> track_id_;
  std::vector<Eigen::Vector2d> path_in_map_;
};

}  // namespace tandem::tracking
