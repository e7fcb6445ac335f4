#include "robot/camera/core/place_confirmation.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace tandem {
namespace {

constexpr Duration kForgotten = std::chrono::seconds{5};
/// Sightings share the errors of mount and pose: many of them do not make the place certain.
constexpr double kLeastVariance = 0.05 * 0.05;

/// The two as one, each weighing by its inverse covariance.
UncertainPoint fused(const UncertainPoint& a, const UncertainPoint& b) {
  const Eigen::Matrix2d floor = Eigen::Matrix2d::Identity() * 1e-9;
  const Eigen::Matrix2d information_a = (a.covariance + floor).inverse();
  const Eigen::Matrix2d information_b = (b.covariance + floor).inverse();
  const Eigen::Matrix2d covariance = (information_a + information_b).inverse();
  return {covariance * (information_a * a.position + information_b * b.position), covariance};
}

}  // namespace

UncertainPoint on_map(const UncertainPoint& point_in_base, const PoseHistory::Entry& pose) {
  const double c = std::cos(pose.map_from_base.heading);
  const double s = std::sin(pose.map_from_base.heading);
  Eigen::Matrix2d rotation;
  rotation << c, -s, s, c;
  const Eigen::Vector2d lever = rotation * point_in_base.position;  // turned by d, the point moves by d * (-y, x)
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << 1.0, 0.0, -lever.y(), 0.0, 1.0, lever.x();
  return {pose.map_from_base * point_in_base.position,
          rotation * point_in_base.covariance * rotation.transpose() + by_pose * pose.covariance * by_pose.transpose()};
}

std::optional<PlaceConfirmation::Confirmed> PlaceConfirmation::add(const UncertainPoint& sighting_in_map,
                                                                   Time frame_time) {
  std::erase_if(places_, [frame_time](const Place& place) {
    return !place.confirmed && frame_time - place.last_seen > kForgotten;
  });
  Place& place = place_of(sighting_in_map);
  if (place.frames > 0 && place.last_seen == frame_time) return std::nullopt;
  place.point_in_map = place.frames == 0 ? sighting_in_map : fused(place.point_in_map, sighting_in_map);
  ++place.frames;
  place.last_seen = frame_time;
  if (place.confirmed || place.frames < frames_to_confirm_) return std::nullopt;
  place.confirmed = true;
  Confirmed confirmed{place.point_in_map, place.frames};
  confirmed.point_in_map.covariance += Eigen::Matrix2d::Identity() * kLeastVariance;
  return confirmed;
}

PlaceConfirmation::Place& PlaceConfirmation::place_of(const UncertainPoint& sighting_in_map) {
  for (Place& place : places_) {
    if ((place.point_in_map.position - sighting_in_map.position).norm() <= same_place_m_) return place;
  }
  return places_.emplace_back();
}

}  // namespace tandem
