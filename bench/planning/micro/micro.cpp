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
#include "services/planner/core/team/prepared_problem.hpp"
#include "services/planner/core/team/route_value.hpp"

namespace tandem::bench {
namespace {

constexpr double kMeasureFor_ms = 1000.0;
constexpr int kRoutes = 64;
constexpr double kAllMissions_s = 5000.0;  ///< longer than any
constexpr double kMissionFound = 0.98;     ///< a plan of the whole mission finds so much

/// A random plan of the whole mission: whoever is free first goes to one of the three nearest lookouts not yet taken,
/// until nearly all is found.
Routes random_mission(const PreparedProblem& prepared, SearchObjective& objective, Rng& rng) {
  const auto& members = prepared.members();
  Routes routes(members.size());
  std::vector<double> free_s(members.size(), 0.0);
  std::vector<std::vector<bool>> taken;
  for (const auto& member : members) taken.emplace_back(static_cast<std::size_t>(member.actions->lookouts()), false);
  std::vector<Look> looks;
  for (int step = 0;; ++step) {
    const auto m = static_cast<std::size_t>(std::ranges::min_element(free_s) - free_s.begin());
    const int from = routes[m].empty() ? members[m].start : routes[m].back();
    std::vector<int> options;
    for (const int lookout : members[m].actions->nearest_lookouts(from)) {
      if (!taken[m][static_cast<std::size_t>(lookout)] && options.size() < 3) options.push_back(lookout);
    }
    if (options.empty()) {  // all near ones are taken: any other
      for (int lookout = 0; lookout < members[m].actions->lookouts(); ++lookout) {
        if (!taken[m][static_cast<std::size_t>(lookout)] && lookout != from) options.push_back(lookout);
      }
    }
    if (options.empty()) return routes;
    const int to = options[rng.index(options.size())];
    taken[m][static_cast<std::size_t>(to)] = true;
    for (std::size_t other = 0; other < members.size(); ++other) {
      if (members[other].actions == members[m].actions) taken[other][static_cast<std::size_t>(to)] = true;
    }
    free_s[m] += members[m].actions->leg(from, to).duration_s;
    routes[m].push_back(to);
    if (step % 4 != 3) continue;
    looks.clear();
    for (std::size_t i = 0; i < members.size(); ++i) prepared.add_looks(i, routes[i], looks);
    if (objective.forecast(looks).probability_found >= kMissionFound) return routes;
  }
}

/// Random plans of the whole mission of an instance, all legs known.
struct Missions {
  explicit Missions(const MicroRecord::Key& key)
      : instance(instance_of(key.family, key.seed)), world(world_of(instance)) {
    while (world->prepare_next()) {
    }
    problem = problem_at_start(instance, *world, prior_mass(*world, instance));
    problem.horizon_s = kAllMissions_s;
    prepared = std::make_unique<PreparedProblem>(problem);
    SearchObjective objective(problem.masses, problem.horizon_s, problem.tail_s);
    Rng rng{key.seed};
    for (int i = 0; i < kRoutes; ++i) routes.push_back(random_mission(*prepared, objective, rng));
  }
  PlanningInstance instance;
  std::unique_ptr<SearchWorld> world;
  SearchProblem problem;
  std::unique_ptr<PreparedProblem> prepared;
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
  const TeamGround ground = team_ground(*missions.prepared);
  RouteValue value(ground);
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
      {"rollouts", {"1/s", rollouts_per_s}},       {"memory", {"MB", peak_memory_mb}},
      {"reproducible", {"", is_reproducible}},     {"searches", {"1/min", searches_per_minute}}};
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
