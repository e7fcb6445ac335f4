#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "robot/camera/core/pose_history.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// A point with how well it is known.
struct UncertainPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    ///< [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< [m2]
};

/// `point_in_base` on the map, with what the pose adds to its uncertainty.
[[nodiscard]] UncertainPoint on_map(const UncertainPoint& point_in_base, const PoseHistory::Entry& pose);

/// Believes in a place once it was sighted in enough pictures, and says so once.
///
/// Sightings within `same_place_m` are of one place; several in one picture count once. A place sighted too rarely is
/// forgotten after 5 s, one that was confirmed never.
class PlaceConfirmation {
 public:
  PlaceConfirmation(int frames_to_confirm, double same_place_m)
      : frames_to_confirm_(frames_to_confirm), same_place_m_(same_place_m) {}

  struct Confirmed {
    UncertainPoint point_in_map;
    int frames = 0;
  };
  /// Adds a sighting in the picture of `frame_time`; the place, if this one confirmed it.
  [[nodiscard]] std::optional<Confirmed> add(const UncertainPoint& sighting_in_map, Time frame_time);
  void clear() { places_.clear(); }

 private:
  struct Place {
    UncertainPoint point_in_map;
    int frames = 0;
    Time last_seen{};
    bool confirmed = false;
  };
  Place& place_of(const UncertainPoint& sighting_in_map);

  int frames_to_confirm_;
  double same_place_m_;
  std::vector<Place> places_;
};

}  // namespace tandem
