// Plays searches on a map with ideal execution: both walk their paths to the letter. Says how good the plans are.
//   build/bench/tandem_planner_play MAP.yaml X Y [SEED [key=value ...]]    (robot and person start at X, Y)
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "services/mapping/core/map_file.hpp"
#include "services/planner/core/mission/search_mission.hpp"

namespace {

using namespace tandem;

double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::fprintf(stderr, "usage: %s MAP.yaml X Y [SEED [key=value ...]]\n", argv[0]);
    return 2;
  }
  std::string toml = "seed = " + std::string(argc > 4 ? argv[4] : "1") + "\n";
  for (int i = 5; i < argc; ++i) toml += std::string(argv[i]) + "\n";
  const auto config = parse_config<PlannerConfig>(toml);
  Pose2 robot{std::atof(argv[2]), std::atof(argv[3]), 0.0};
  Pose2 person{robot.x - 1.0, robot.y, 0.0};
  SearchMission mission(config, "robot", "person");
  mission.set_map(load_map(argv[1]));
  Time now = from_stamp_ns(1'700'000'000'000'000'000);
  const Time start = now;
  const Duration tick = std::chrono::milliseconds{200};
  mission.robot_at(now, robot);
  mission.person_at(now, person, 0.0);
  double before_ms = cpu_ms();
  mission.step(now, [] { return false; });
  std::printf("preparation: %.0f ms, %d cells, %.0f m2\n", cpu_ms() - before_ms, mission.area()->size(),
              mission.area()->area_m2());
  mission.run_session("play", now);

  double expected_s = 0.0;
  double explored95_s = -1.0;
  double longest_ms = 0.0;
  double sum_ms = 0.0;
  int plans = 0;
  while (now - start < std::chrono::minutes{20} && mission.belief()->probability_left() > 0.01) {
    before_ms = cpu_ms();
    if (mission.step(now, [] { return false; })) {
      const double plan_ms = cpu_ms() - before_ms;
      longest_ms = std::max(longest_ms, plan_ms);
      sum_ms += plan_ms;
      ++plans;
      const MissionPlan& plan = *mission.plan();
      std::printf("%6.1f s  plan in %4.0f ms: E[T] %.1f s, P(found) %.2f, %s; robot %.0f s, person %.0f s\n",
                  to_seconds(now - start), plan_ms, plan.forecast.expected_time_s, plan.forecast.probability_found,
                  plan.reason.c_str(), plan.members[0].path.duration_s(),
                  plan.members.size() > 1 ? plan.members[1].path.duration_s() : 0.0);
    }
    now += tick;
    if (const auto& plan = mission.plan(); plan && mission.standing(now) == PlanStanding::Accepted) {
      const double time_s = to_seconds(now - plan->start);
      robot = pose_at(plan->members[0].path, time_s);
      if (plan->members.size() > 1) person = pose_at(plan->members[1].path, time_s);
      mission.robot_progress({plan->id, time_s >= plan->members[0].path.duration_s(), false, {0, 0}}, now);
    }
    mission.robot_at(now, robot);
    mission.person_at(now, person, 0.0);
    expected_s += mission.belief()->probability_left() * to_seconds(tick);
    if (explored95_s < 0.0 && mission.explored().all >= 0.95) explored95_s = to_seconds(now - start);
  }
  const auto explored = mission.explored();
  std::printf("E[T] %.1f s, 95 %% explored after %.0f s, P(left) %.3f after %.0f s\n", expected_s, explored95_s,
              mission.belief()->probability_left(), to_seconds(now - start));
  std::printf("explored %.3f (robot %.3f, person %.3f); %d plans, %.0f ms mean, %.0f ms longest\n", explored.all,
              explored.by_agent[0], explored.by_agent[1], plans, sum_ms / std::max(1, plans), longest_ms);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
