#include "bench/planning/micro/micro.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <thread>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/cpu_clock.hpp"
#include "bench/planning/loop/first_plan.hpp"
#include "bench/planning/loop/run_plan.hpp"
#include "services/common/config.hpp"
#include "services/planner/core/team/joint_walk.hpp"
#include "services/planner/core/team/prepared_problem.hpp"
#include "services/planner/core/team/refinement.hpp"
#include "services/planner/core/team/route_value.hpp"

namespace tandem::bench {
namespace {

constexpr double kMeasureFor_ms = 1000.0;
constexpr int kRoutes = 64;
constexpr int kMovesAtATime = 1000;

/// The greedy plan of a whole mission.
Routes greedy_mission(const TeamGround& ground) {
  JointWalk walk(ground, {});
  for (int m = walk.next_member(); m >= 0; m = walk.next_member()) walk.choose(m, walk.choices(m, 1).front().place);
  return walk.routes();
}

/// Plans of the whole mission of an instance as the planner finds them one after the other, from the greedy one on.
struct Missions {
  explicit Missions(const MicroRecord::Key& key)
      : instance(instance_of(key.family, key.seed)), world(world_of(instance)) {
    while (world->prepare_next()) {
    }
    problem = problem_at_start(instance, *world, prior_mass(*world, instance));
    prepared = std::make_unique<PreparedProblem>(problem);
    ground = team_ground(*prepared);
    RouteValue value(ground);
    Rng rng{key.seed};
    Refinement refinement(ground, value, {});
    const Routes greedy = greedy_mission(ground);
    refinement.restart(greedy, value.value_s(greedy));
    for (int i = 0; i < kRoutes; ++i) {
      refinement.improve(kMovesAtATime, rng);
      routes.push_back(refinement.best());
    }
  }
  PlanningInstance instance;
  std::unique_ptr<SearchWorld> world;
  SearchProblem problem;
  std::unique_ptr<PreparedProblem> prepared;
  TeamGround ground;
  std::vector<Routes> routes;
};

/// How often `value_s` values one of the missions per second, once all is warm.
double values_per_s(const Missions& missions, const std::function<double(const Routes&)>& value_s) {
  double sum_s = 0.0;
  for (const Routes& routes : missions.routes) sum_s += value_s(routes);
  std::int64_t evaluations = 0;
  const double begin_ms = thread_cpu_ms();
  double now_ms = begin_ms;
  for (; now_ms - begin_ms < kMeasureFor_ms; now_ms = thread_cpu_ms()) {
    for (const Routes& routes : missions.routes) sum_s += value_s(routes);
    evaluations += kRoutes;
  }
  return sum_s > 0.0 ? 1e3 * static_cast<double>(evaluations) / (now_ms - begin_ms) : 0.0;
}

double evaluations_per_s(const MicroRecord::Key& key) {
  const Missions missions(key);
  RouteValue value(missions.ground);
  return values_per_s(missions, [&](const Routes& routes) { return value.value_s(routes); });
}

double objective_evaluations_per_s(const MicroRecord::Key& key) {
  const Missions missions(key);
  SearchObjective objective(missions.problem.masses, missions.problem.horizon_s, missions.problem.tail_s);
  std::vector<Look> looks;
  return values_per_s(missions, [&](const Routes& routes) {
    looks.clear();
    for (std::size_t m = 0; m < routes.size(); ++m) missions.prepared->add_looks(m, routes[m], looks);
    return objective.forecast(looks).expected_time_s;
  });
}

/// Changes of one plan that are judged per second, each by what it changes.
double changes_per_s(const MicroRecord::Key& key) {
  const Missions missions(key);
  RouteValue value(missions.ground);
  Refinement refinement(missions.ground, value, {});
  refinement.restart(missions.routes.front(), value.value_s(missions.routes.front()));
  Rng rng{key.seed};
  const double begin_ms = thread_cpu_ms();
  double now_ms = begin_ms;
  for (; now_ms - begin_ms < kMeasureFor_ms; now_ms = thread_cpu_ms()) refinement.improve(kMovesAtATime, rng);
  return 1e3 * static_cast<double>(refinement.judged()) / (now_ms - begin_ms);
}

double rollouts_per_s(const MicroRecord::Key& key) {
  const FirstPlanRecord record = made_first_plan({{key.family, key.seed, "tandem", 1}, {kMeasureFor_ms}});
  return 1e3 * record.rollouts.back() / (kMeasureFor_ms - record.first_plan_ms);
}

double peak_memory_mb(const MicroRecord::Key& key) {
  const pid_t child = fork();
  if (child == 0) {
    (void)made_first_plan({{key.family, key.seed, "tandem", 1}, {200.0}});
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double is_reproducible(const MicroRecord::Key& key) {
  const RunRequest request{{key.family, key.seed, "tandem", "200rollouts", 1}, {0.0, 200}};
  const double alone_s = made_run(request).expected_time_s;
  double first_s = 0.0;
  double second_s = 0.0;
  {
    const std::jthread other([&] { first_s = made_run(request).expected_time_s; });
    second_s = made_run(request).expected_time_s;
  }
  return first_s == alone_s && second_s == alone_s ? 1.0 : 0.0;
}

double searches_per_minute(const MicroRecord::Key& key) {
  // The map is prepared once for many searches, so that does not count.
  const double begin_ms = thread_cpu_ms();
  const RunRecord record = made_run({{key.family, key.seed, "tandem", "10ms", 1}, {10.0}});
  return 60e3 / (thread_cpu_ms() - begin_ms - record.prepare_ms);
}

struct Measure {
  std::string unit;
  std::function<double(const MicroRecord::Key&)> value;
};

const std::map<std::string, Measure>& measures() {
  static const std::map<std::string, Measure> all{
      {"evaluations", {"1/s", evaluations_per_s}}, {"objective", {"1/s", objective_evaluations_per_s}},
      {"changes", {"1/s", changes_per_s}},         {"rollouts", {"1/s", rollouts_per_s}},
      {"memory", {"MB", peak_memory_mb}},          {"reproducible", {"", is_reproducible}},
      {"searches", {"1/min", searches_per_minute}}};
  return all;
}

}  // namespace

std::vector<std::string> micro_measures() {
  std::vector<std::string> names;
  for (const auto& [name, measure] : measures()) names.push_back(name);
  return names;
}

MicroRecord measured(const MicroRequest& request) {
  const auto measure = measures().find(request.key.measure);
  if (measure == measures().end()) throw ConfigError("nothing is measured by the name '" + request.key.measure + "'");
  return {request.key, measure->second.value(request.key), measure->second.unit};
}

}  // namespace tandem::bench
