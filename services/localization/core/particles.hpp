#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/localization/core/likelihood_field.hpp"
#include "services/localization/core/motion_model.hpp"

namespace tandem {

/// A guess of where the robot is. The weights of a set add up to 1.
struct Particle {
  Pose2 map_from_base;
  double weight = 0.0;
};
using Particles = std::vector<Particle>;

/// `count` equally heavy particles, normally distributed around `map_from_base`.
[[nodiscard]] Particles particles_around(const Pose2& map_from_base, double deviation_m, double deviation_rad,
                                         std::size_t count, Rng& rng);

/// `count` equally heavy particles, uniform over the free cells of `grid` and all headings; none if no cell is free.
[[nodiscard]] Particles particles_everywhere(const OccupancyGrid& grid, std::size_t count, Rng& rng);

/// Moves each particle by a motion that the wheels may have reported as `before_from_after`.
void move(Particles& particles, const Pose2& before_from_after, const MotionDeviation& deviation, Rng& rng);

/// Multiplies each weight by the likelihood of the endpoints, each beam counting as `beam_weight` of one; normalises.
void weigh(Particles& particles, const LikelihoodField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
           double beam_weight);

/// Makes the weights add up to 1; equal if there is nothing to share out.
void normalise(Particles& particles);

/// 1 / sum of squared weights, as a share of the count: 1 when all weigh the same.
[[nodiscard]] double effective_share(const Particles& particles);

/// `count` equally heavy particles drawn by weight with one random number (low variance).
[[nodiscard]] Particles resampled(const Particles& particles, std::size_t count, Rng& rng);

/// Puts `share` of the particles at the end of the set around `pose`; the weights stay normalised.
void gather(Particles& particles, double share, const Pose2& pose, double deviation_m, double deviation_rad, Rng& rng);

/// How many particles keep the error of the set below `error` with the certainty of `quantile` (KLD sampling, Fox
/// 2003), by the number of 0.5 m x 0.5 m x 15 degree bins that hold weight.
[[nodiscard]] std::size_t kld_count(const Particles& particles, double error, double quantile);

/// Particles that lie together.
struct Cluster {
  Pose2 map_from_base;  ///< weighted mean
  Covariance3 covariance = Covariance3::Zero();
  double weight = 0.0;  ///< [0, 1]
};

/// The particles grouped around the heaviest ones, at most `count` groups, heaviest group first.
[[nodiscard]] std::vector<Cluster> clusters(const Particles& particles, std::size_t count);

}  // namespace tandem
