#include "services/map_builder/core/map_graph.hpp"

#include "services/localization/core/motion_model.hpp"

namespace tandem {

Surface surface_of(const MapScan& scan, const MapBuilderConfig& config) {
  return surface_of(scan.endpoints_in_base, scan.laser_in_base, static_cast<std::size_t>(config.scan_points));
}

Eigen::Matrix3d information_of_wheels(const Pose2& motion, const MapBuilderConfig& config) {
  const MotionDeviation deviation = deviation_of(motion, config.wheels);
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
