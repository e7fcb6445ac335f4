#include "services/localization/core/particles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tandem {
namespace {

constexpr double kClusterRadiusM = 1.0;
constexpr double kClusterRadiusRad = 0.6;

/// A bin of kld_count as one number.
std::int64_t bin_of(const Pose2& pose) {
  const auto x = static_cast<std::int64_t>(std::floor(pose.x / 0.5));
  const auto y = static_cast<std::int64_t>(std::floor(pose.y / 0.5));
  const auto heading = static_cast<std::int64_t>(std::floor(pose.heading * 12.0 / std::numbers::pi));
  return (x * 2'000'003 + y) * 32 + heading + 16;
}

bool is_near(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).squaredNorm() < kClusterRadiusM * kClusterRadiusM &&
         std::abs(turn_between(a.heading, b.heading)) < kClusterRadiusRad;
}

/// Mean and covariance of the members; `centre` gives the branch of the heading.
Cluster cluster_of(const Particles& particles, const std::vector<std::size_t>& members, const Pose2& centre) {
  Cluster cluster;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (const std::size_t i : members) {
    const Particle& particle = particles[i];
    const Eigen::Vector3d offset{particle.map_from_base.x - centre.x, particle.map_from_base.y - centre.y,
                                 turn_between(centre.heading, particle.map_from_base.heading)};
    cluster.weight += particle.weight;
    mean += particle.weight * offset;
    square += particle.weight * offset * offset.transpose();
  }
  if (cluster.weight > 0.0) {
    mean /= cluster.weight;
    square /= cluster.weight;
  }
  cluster.map_from_base = {centre.x + mean.x(), centre.y + mean.y(), wrap_to_pi(centre.heading + mean.z())};
  cluster.covariance = square - mean * mean.transpose();
  return cluster;
}

}  // namespace

Particles particles_around(const Pose2& map_from_base, double deviation_m, double deviation_rad, std::size_t count,
                           Rng& rng) {
  Particles particles;
  particles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = rng.normal(map_from_base.x, deviation_m);
    const double y = rng.normal(map_from_base.y, deviation_m);
    const double heading = wrap_to_pi(rng.normal(map_from_base.heading, deviation_rad));
    particles.push_back({{x, y, heading}, 1.0 / static_cast<double>(count)});
  }
  return particles;
}

Particles particles_everywhere(const OccupancyGrid& grid, std::size_t count, Rng& rng) {
  std::vector<CellIndex> free_cells;
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      if (grid.is_free({column, row})) free_cells.push_back({column, row});
    }
  }
  Particles particles;
  if (free_cells.empty()) return particles;
  particles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d p = grid.centre_in_map(free_cells[rng.index(free_cells.size())]);
    particles.push_back(
        {{p.x(), p.y(), rng.uniform(-std::numbers::pi, std::numbers::pi)}, 1.0 / static_cast<double>(count)});
  }
  return particles;
}

void move(Particles& particles, const Pose2& before_from_after, const MotionDeviation& deviation, Rng& rng) {
  for (Particle& particle : particles) {
    particle.map_from_base = particle.map_from_base * sampled_motion(before_from_after, deviation, rng);
  }
}

void weigh(Particles& particles, const LikelihoodField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
           double beam_weight) {
  const double factor = beam_weight * static_cast<double>(endpoints_in_base.size());
  std::vector<double> log_weights;
  log_weights.reserve(particles.size());
  double best = -std::numeric_limits<double>::infinity();
  for (const Particle& particle : particles) {
    const double log_weight =
        std::log(particle.weight) + factor * field.mean_log_likelihood(particle.map_from_base, endpoints_in_base);
    log_weights.push_back(log_weight);
    best = std::max(best, log_weight);
  }
  for (std::size_t i = 0; i < particles.size(); ++i) particles[i].weight = std::exp(log_weights[i] - best);
  normalise(particles);
}

void normalise(Particles& particles) {
  double sum = 0.0;
  for (const Particle& particle : particles) sum += particle.weight;
  for (Particle& particle : particles) {
    particle.weight = sum > 0.0 ? particle.weight / sum : 1.0 / static_cast<double>(particles.size());
  }
}

double effective_share(const Particles& particles) {
  double squares = 0.0;
  for (const Particle& particle : particles) squares += particle.weight * particle.weight;
  return squares > 0.0 ? 1.0 / (squares * static_cast<double>(particles.size())) : 0.0;
}

Particles resampled(const Particles& particles, std::size_t count, Rng& rng) {
  assert(!particles.empty() && count > 0);
  const double step = 1.0 / static_cast<double>(count);
  const double first = rng.uniform() * step;
  Particles drawn;
  drawn.reserve(count);
  std::size_t source = 0;
  double reached = particles[0].weight;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = first + static_cast<double>(i) * step;
    while (reached < wanted && source + 1 < particles.size()) reached += particles[++source].weight;
    drawn.push_back({particles[source].map_from_base, step});
  }
  return drawn;
}

void gather(Particles& particles, double share, const Pose2& pose, double deviation_m, double deviation_rad, Rng& rng) {
  const auto count = static_cast<std::size_t>(share * static_cast<double>(particles.size()));
  if (count == 0) return;
  const Particles gathered = particles_around(pose, deviation_m, deviation_rad, count, rng);
  const std::size_t first = particles.size() - count;
  for (std::size_t i = 0; i < count; ++i) particles[first + i].map_from_base = gathered[i].map_from_base;
}

std::size_t kld_count(const Particles& particles, double error, double quantile) {
  std::vector<std::int64_t> bins;
  bins.reserve(particles.size());
  const double worth_counting = 0.01 / static_cast<double>(particles.size());
  for (const Particle& particle : particles) {
    if (particle.weight >= worth_counting) bins.push_back(bin_of(particle.map_from_base));
  }
  std::sort(bins.begin(), bins.end());
  const auto occupied = std::unique(bins.begin(), bins.end()) - bins.begin();
  if (occupied < 2) return 1;
  const auto k = static_cast<double>(occupied - 1);
  const double a = 2.0 / (9.0 * k);
  return static_cast<std::size_t>(k / (2.0 * error) * std::pow(1.0 - a + std::sqrt(a) * quantile, 3.0));
}

std::vector<Cluster> clusters(const Particles& particles, std::size_t count) {
  std::vector<std::size_t> left(particles.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<Cluster> found;
  while (!left.empty() && found.size() < count) {
    std::size_t heaviest = left.front();
    for (const std::size_t i : left) {
      if (particles[i].weight > particles[heaviest].weight) heaviest = i;
    }
    const Pose2 centre = particles[heaviest].map_from_base;
    const auto others = std::stable_partition(
        left.begin(), left.end(), [&](std::size_t i) { return is_near(particles[i].map_from_base, centre); });
    found.push_back(cluster_of(particles, {left.begin(), others}, centre));
    left.erase(left.begin(), others);
  }
  std::stable_sort(found.begin(), found.end(), [](const Cluster& a, const Cluster& b) { return a.weight > b.weight; });
  return found;
}

}  // namespace tandem
