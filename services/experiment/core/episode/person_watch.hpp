#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/mapping/core/occupancy_grid.hpp"
#include "services/simulator/core/phone_user.hpp"
#include "services/tracking/core/people_tracker.hpp"
#include "services/tracking/core/teammate.hpp"

namespace tandem::experiment {

/// What the team knows of where its person is: the tracker, fed with whom the laser would see and with *My pose*.
class PersonWatch {
 public:
  PersonWatch(const tracking::TrackingConfig& config, Rng rng);

  /// One turn of the laser: people in line of sight ahead and aside, within 6 m, about where they are.
  void see(Time now, const OccupancyGrid& map, const Pose2& map_from_base, std::span<const Eigen::Vector2d> people);
  /// *My pose*.
  void hear(Time now, const simulator::PhoneMessage& message);
  /// The person's path of the accepted plan; empty: there is none.
  void follow(std::vector<Eigen::Vector2d> path_in_map) { teammate_.follow(std::move(path_in_map)); }

  [[nodiscard]] std::optional<tracking::TeammateEstimate> estimate(Time now) const { return teammate_.estimate(now); }

 private:
  tracking::TrackingConfig config_;
  Rng rng_;
  tracking::PeopleTracker people_;
  tracking::Teammate teammate_;
};

}  // namespace tandem::experiment
