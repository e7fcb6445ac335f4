#include "bench/planning/srs_worlds/srs_world.hpp"

#include <string>

#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

constexpr double kSide_m = 20.0;

Vector2d random_point(Rng& rng) {
  const double x = rng.uniform(1.0, kSide_m - 1.0);
  return {x, rng.uniform(1.0, kSide_m - 1.0)};
}

int between(Rng& rng, int low, int high) {
  return low + static_cast<int>(rng.index(static_cast<std::size_t>(high - low + 1)));
}

RewardSource random_source(Rng& rng, int number, const std::vector<std::string>& agents) {
  RewardSource source;
  source.id = "s" + std::to_string(number);
  const Vector2d centre = random_point(rng);
  source.boundary = Disc{centre, rng.uniform(0.3, 0.7)};
  const double pool = rng.uniform(1.0, 10.0);
  const double consumption_s = rng.uniform(0.5, 6.0);
  if (rng.uniform() < 0.12) {
    source.inside = constant_ratio(rng.uniform(0.05, 0.3));  // without a limit
  } else {
    source.inside = constant_ratio(pool / consumption_s);
    source.pool = pool;
  }
  if (agents.size() > 1 && rng.uniform() < 0.25) source.targets = {agents[rng.index(agents.size())]};
  if (rng.uniform() < 0.2) {
    source.tempers.push_back({agents[rng.index(agents.size())], rng.uniform(0.5, 2.0), rng.uniform(0.5, 1.5)});
  }
  return source;
}

RewardSource cost_of_walking(Rng& rng) {
  RewardSource source;
  source.id = "walking";
  source.kind = SourceKind::Action;
  source.boundary = SpeedInterval{0.01, 10.0};
  source.inside = constant_ratio(-rng.uniform(0.02, 0.2));
  return source;
}

RewardSource random_hazard(Rng& rng) {
  RewardSource source;
  source.id = "hazard";
  source.kind = SourceKind::Environment;
  const Vector2d centre = random_point(rng);
  source.boundary = Disc{centre, rng.uniform(1.0, 2.5)};
  source.inside = constant_ratio(-rng.uniform(0.3, 2.0));
  return source;
}

/// From a lower to a higher number, so that no circle arises.
Relation random_relation(Rng& rng, const std::vector<RewardSource>& sources) {
  const std::size_t to = 1 + rng.index(sources.size() - 1);
  const std::size_t from = rng.index(to);
  const double draw = rng.uniform();
  Relation relation;
  relation.kind = draw < 0.4 ? RelationKind::Strict : draw < 0.75 ? RelationKind::Soft : RelationKind::Codependent;
  relation.from = sources[from].id;
  relation.to = sources[to].id;
  if (relation.kind == RelationKind::Codependent) relation.coupling = rng.uniform() < 0.5 ? 1.0 : 0.5;
  return relation;
}

}  // namespace

TaskProblem random_srs_task(std::uint64_t seed, const SrsWorldOptions& options) {
  Rng rng{seed * 2654435761U + 7U};
  TaskProblem problem;
  const int agents = between(rng, 1, options.most_agents);
  for (int i = 0; i < agents; ++i) {
    TaskAgent agent;
    agent.searcher.id = "a" + std::to_string(i);
    agent.searcher.speed_mps = rng.uniform(0.5, 1.5);
    const Vector2d start = random_point(rng);
    agent.start = {start.x(), start.y(), 0.0};
    problem.world.agents.push_back(agent.searcher.id);
    problem.agents.push_back(agent);
  }
  RewardWorld& world = problem.world;
  const int count = between(rng, options.least_sources, options.most_sources);
  for (int i = 0; i < count; ++i) world.sources.push_back(random_source(rng, i, world.agents));
  const std::vector<RewardSource> tasks = world.sources;
  world.sources.push_back(cost_of_walking(rng));
  if (rng.uniform() < 0.3) world.sources.push_back(random_hazard(rng));
  for (int wanted = between(rng, 1, count); wanted > 0; --wanted) {
    const Relation relation = random_relation(rng, tasks);
    world.relations.push_back(relation);
    if (problem_of(world)) world.relations.pop_back();
  }
  problem.horizon_s = rng.uniform(15.0, 60.0);
  return problem;
}

}  // namespace tandem::bench
