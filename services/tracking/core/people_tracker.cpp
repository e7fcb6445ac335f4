#include "services/tracking/core/people_tracker.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "services/tracking/core/assignment.hpp"

namespace tandem::tracking {
namespace {

Eigen::Matrix2d spread_of(const Sighting& sighting) {
  return Eigen::Matrix2d::Identity() * sighting.standard_deviation_m * sighting.standard_deviation_m;
}

}  // namespace

double Motion::standard_deviation_m() const {
  const double a = covariance(0, 0);
  const double b = covariance(0, 1);
  const double c = covariance(1, 1);
  return std::sqrt(0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b));
}

Motion predicted(const Motion& motion, double step_s, double acceleration_mps2) {
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition(0, 2) = transition(1, 3) = step_s;
  const double q = acceleration_mps2 * acceleration_mps2;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  noise.topLeftCorner<2, 2>().diagonal().setConstant(q * step_s * step_s * step_s / 3.0);
  noise.topRightCorner<2, 2>().diagonal().setConstant(q * step_s * step_s / 2.0);
  noise.bottomLeftCorner<2, 2>().diagonal().setConstant(q * step_s * step_s / 2.0);
  noise.bottomRightCorner<2, 2>().diagonal().setConstant(q * step_s);
  return {transition * motion.mean, transition * motion.covariance * transition.transpose() + noise};
}

double squared_distance(const Motion& motion, const Sighting& sighting) {
  const Eigen::Matrix2d spread = motion.covariance.topLeftCorner<2, 2>() + spread_of(sighting);
  const Eigen::Vector2d off = sighting.position_in_map - motion.position();
  return off.dot(spread.inverse() * off);
}

Motion corrected(const Motion& motion, const Sighting& sighting) {
  const Eigen::Matrix2d spread = motion.covariance.topLeftCorner<2, 2>() + spread_of(sighting);
  const Eigen::Matrix<double, 4, 2> gain = motion.covariance.leftCols<2>() * spread.inverse();
  Motion result;
  result.mean = motion.mean + gain * (sighting.position_in_map - motion.position());
  const Eigen::Matrix4d covariance = motion.covariance - gain * motion.covariance.topRows<2>();
  result.covariance = 0.5 * (covariance + covariance.transpose());
  return result;
}

void PeopleTracker::update(Time time, const std::vector<Sighting>& sightings) {
  const double step_s = tracks_.empty() ? 0.0 : std::max(0.0, to_seconds(time - time_));
  time_ = time;
  for (Track& track : tracks_) track.motion = predicted(track.motion, step_s, config_.acceleration_mps2);

  const std::vector<bool> given = give_out(time, sightings);
  std::erase_if(tracks_, [&](const Track& track) {
    return time - track.last_seen > from_seconds(track.confirmed ? config_.lose_after_s : config_.tentative_s);
  });
  begin_tracks(time, sightings, given);
}

std::vector<bool> PeopleTracker::give_out(Time time, const std::vector<Sighting>& sightings) {
  Eigen::MatrixXd costs(static_cast<Eigen::Index>(tracks_.size()), static_cast<Eigen::Index>(sightings.size()));
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    for (std::size_t s = 0; s < sightings.size(); ++s) {
      const double distance = squared_distance(tracks_[t].motion, sightings[s]);
      costs(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(s)) =
          distance < config_.gate ? distance : std::numeric_limits<double>::infinity();
    }
  }
  const auto sighting_of = best_assignment(costs);
  std::vector<bool> given(sightings.size(), false);
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    if (!sighting_of[t]) continue;
    const auto s = static_cast<std::size_t>(*sighting_of[t]);
    given[s] = true;
    Track& track = tracks_[t];
    track.motion = corrected(track.motion, sightings[s]);
    track.last_seen = time;
    ++track.hits;
    track.confirmed = track.confirmed || track.hits >= config_.hits_to_confirm;
    const bool walked = (track.motion.position() - track.first_position_in_map).norm() > config_.moved_m;
    track.person = track.person || (track.confirmed && (sightings[s].pair || walked));
  }
  return given;
}

void PeopleTracker::begin_tracks(Time time, const std::vector<Sighting>& sightings, const std::vector<bool>& given) {
  for (std::size_t s = 0; s < sightings.size(); ++s) {
    if (given[s]) continue;
    const Sighting& sighting = sightings[s];
    // The second leg of somebody followed already, or a shadow of one.
    const bool known = std::any_of(tracks_.begin(), tracks_.end(), [&](const Track& track) {
      return (track.motion.position() - sighting.position_in_map).norm() < config_.min_separation_m;
    });
    if (known) continue;
    Track track;
    track.id = next_id_++;
    track.motion.mean << sighting.position_in_map, Eigen::Vector2d::Zero();
    const double speed = config_.first_speed_deviation_mps;
    track.motion.covariance.setZero();
    track.motion.covariance.topLeftCorner<2, 2>() = spread_of(sighting);
    track.motion.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(speed * speed);
    track.first_seen = track.last_seen = time;
    track.first_position_in_map = sighting.position_in_map;
    track.hits = 1;
    track.confirmed = config_.hits_to_confirm <= 1;
    track.person = track.confirmed && sighting.pair;
    tracks_.push_back(track);
  }
}

const Track* PeopleTracker::find(std::uint32_t id) const {
  const auto track =
      std::find_if(tracks_.begin(), tracks_.end(), [id](const Track& one) { return one.id == id && one.confirmed; });
  return track == tracks_.end() ? nullptr : &*track;
}

}  // namespace tandem::tracking
