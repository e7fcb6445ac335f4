#include "services/localization/core/particles.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

double sum_of_weights(const Particles& particles) {
  double sum = 0.0;
  for (const Particle& particle : particles) sum += particle.weight;
  return sum;
}

TEST(Particles, ResamplingDrawsByWeight) {
  const Particles two{{{0.0, 0.0, 0.0}, 0.25}, {{1.0, 0.0, 0.0}, 0.75}};
  Rng rng{1};

  const Particles drawn = resampled(two, 8, rng);

  int at_one = 0;
  for (const Particle& particle : drawn) at_one += particle.map_from_base.x == 1.0 ? 1 : 0;
  EXPECT_EQ(at_one, 6);  // three quarters of eight, whatever the seed
  EXPECT_NEAR(sum_of_weights(drawn), 1.0, 1e-12);
}

TEST(Particles, EffectiveShareIsOneWhenAllWeighTheSame) {
  EXPECT_DOUBLE_EQ(effective_share({{{}, 0.5}, {{}, 0.5}}), 1.0);
  EXPECT_DOUBLE_EQ(effective_share({{{}, 1.0}, {{}, 0.0}}), 0.5);
}

TEST(Particles, AreHeavyWhereTheScanFits) {
  const OccupancyGrid map = test::ascii_map({"....#"});
  const LikelihoodField field{map, DistanceField{map}, BeamModel{1.0, 0.5}};
  Particles particles{{{2.5, 0.5, 0.0}, 0.5}, {{0.5, 0.5, 0.0}, 0.5}};

  weigh(particles, field, std::vector<Eigen::Vector2d>(3, {2.0, 0.0}), 1.0);

  EXPECT_GT(particles[0].weight, 0.7);
  EXPECT_NEAR(sum_of_weights(particles), 1.0, 1e-12);
}

TEST(Particles, MoveAsTheWheelsSayWithoutNoise) {
  Particles particles{{{1.0, 1.0, std::numbers::pi / 2.0}, 1.0}};
  Rng rng{1};

  move(particles, {2.0, 0.0, 0.0}, {}, rng);

  EXPECT_NEAR(particles[0].map_from_base.x, 1.0, 1e-12);
  EXPECT_NEAR(particles[0].map_from_base.y, 3.0, 1e-12);
}

TEST(Particles, SpreadAsTheMotionModelSays) {
  const MotionDeviation deviation = deviation_of({2.0, 0.0, 0.0}, {.forward_per_m = 0.1, .turn_per_m = 0.05});
  EXPECT_DOUBLE_EQ(deviation.forward_m, 0.2);
  EXPECT_DOUBLE_EQ(deviation.turn_rad, 0.1);

  Rng rng{5};
  Particles particles = particles_around({}, 0.0, 0.0, 20'000, rng);
  move(particles, {2.0, 0.0, 0.0}, deviation, rng);
  double square = 0.0;
  for (const Particle& p : particles) square += p.weight * (p.map_from_base.x - 2.0) * (p.map_from_base.x - 2.0);
  EXPECT_NEAR(std::sqrt(square), 0.2, 0.01);
}

TEST(Particles, EverywhereMeansOnFreeCells) {
  const OccupancyGrid map = test::ascii_map({"#.?", "##."});
  Rng rng{2};

  for (const Particle& particle : particles_everywhere(map, 100, rng)) {
    EXPECT_EQ(map.at(particle.map_from_base.position()), CellState::Free);
  }
  EXPECT_TRUE(particles_everywhere(test::ascii_map({"##"}), 100, rng).empty());
}

TEST(Particles, CountGrowsWithTheirSpread) {
  Rng rng{3};
  const Particles close = particles_around({5.1, 5.1, 0.1}, 0.01, 0.01, 1000, rng);
  const Particles wide = particles_around({5.1, 5.1, 0.1}, 5.0, 1.0, 1000, rng);

  EXPECT_EQ(kld_count(close, 0.05, 2.33), 1U);
  EXPECT_GT(kld_count(wide, 0.05, 2.33), 1000U);
}

TEST(Clusters, AreMeansOfParticlesThatLieTogether) {
  const double pi = std::numbers::pi;
  const Particles particles{{{0.0, 0.0, pi - 0.1}, 0.3}, {{0.2, 0.0, -pi + 0.1}, 0.3}, {{10.0, 0.0, 0.0}, 0.4}};

  const auto groups = clusters(particles, 5);

  ASSERT_EQ(groups.size(), 2U);
  EXPECT_NEAR(groups[0].weight, 0.6, 1e-12);
  EXPECT_NEAR(groups[0].map_from_base.x, 0.1, 1e-12);
  EXPECT_NEAR(std::abs(groups[0].map_from_base.heading), pi, 1e-12);  // across the cut of the circle
  EXPECT_NEAR(groups[0].covariance(0, 0), 0.01, 1e-12);
  EXPECT_NEAR(groups[1].map_from_base.x, 10.0, 1e-12);
}

}  // namespace
}  // namespace tandem
