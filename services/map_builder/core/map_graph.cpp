#include "services/map_builder/core/map_graph.hpp"

#include "services/localization/core/motion_model.hpp"

namespace tandem {

Eigen::Matrix3d information_of_wheels(const Pose2& motion, const MapBuilderConfig& config) {
  const MotionDeviation deviation = deviation_of(motion, {.forward_per_m = config.forward_per_m,
                                                          .sideways_per_m = config.sideways_per_m,
                                                          .turn_per_rad = config.turn_per_rad,
                                                          .turn_per_m = config.turn_per_m,
                                                          .drift_m = config.drift_m,
                                                          .drift_rad = config.drift_rad});
  return Eigen::Vector3d{deviation.forward_m, deviation.sideways_m, deviation.turn_rad}
      .cwiseAbs2()
      .cwiseInverse()
      .asDiagonal();
}

RegistrationOptions registration_options(const MapBuilderConfig& config) {
  return {.first_reach_m = config.first_reach_m,
          .last_reach_m = config.last_reach_m,
          .loss_m = config.loss_m,
          .deviation_m = config.point_deviation_m,
          .point_weight = config.point_weight};
}

}  // namespace tandem
