#include "services/experiment/core/episode/person_watch.hpp"

#include <cmath>

#include "services/common/angle.hpp"
#include "services/mapping/core/ray_casting.hpp"

namespace tandem::experiment {
namespace {

constexpr double kRange_m = 6.0;  ///< farther away the laser finds one leg at best
constexpr double kHalfField_rad = from_degrees(120.0);

}  // namespace

PersonWatch::PersonWatch(const tracking::TrackingConfig& config, Rng rng)
    : config_(config), rng_(rng), people_(config), teammate_(config) {}

void PersonWatch::see(Time now, const OccupancyGrid& map, const Pose2& map_from_base,
                      std::span<const Eigen::Vector2d> people) {
  std::vector<tracking::Sighting> sightings;
  const Eigen::Vector2d here = map_from_base.position();
  for (const Eigen::Vector2d& person : people) {
    const Eigen::Vector2d in_base = inverse(map_from_base) * person;
    if (in_base.norm() > kRange_m || std::abs(std::atan2(in_base.y(), in_base.x())) > kHalfField_rad) continue;
    if (!line_of_sight(map, here, person)) continue;
    const double deviation_m = config_.pair_deviation_m;
    const Eigen::Vector2d error{rng_.normal(0.0, deviation_m), rng_.normal(0.0, deviation_m)};
    sightings.push_back({person + error, deviation_m, true});
  }
  people_.update(now, sightings);
  teammate_.see(now, people_);
}

void PersonWatch::hear(Time now, const simulator::PhoneMessage& message) {
  if (!message.point_in_map) return;
  teammate_.hear({now, *message.point_in_map, message.heading}, people_);
}

}  // namespace tandem::experiment
