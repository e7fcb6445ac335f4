#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "bench/planning/srs_worlds/srs_world.hpp"
#include "bench/planning/srs_worlds/task_oracle.hpp"

// Family S7: how often the task planner finds the optimum of small random worlds within its budget, and how far off it
// is at worst. Usage: tandem_srs_worlds [first seed] [worlds] [budget ms] [most sources] [most oracle decisions]

namespace {

double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double argument(int argc, char** argv, int number, double fallback) {
  return argc > number ? std::atof(argv[number]) : fallback;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tandem;
  const auto first = static_cast<std::uint64_t>(argument(argc, argv, 1, 1));
  const auto worlds = static_cast<std::uint64_t>(argument(argc, argv, 2, 50));
  const double budget_ms = argument(argc, argv, 3, 200);
  bench::SrsWorldOptions options;
  options.most_sources = static_cast<int>(argument(argc, argv, 4, 8));
  if (options.most_sources > 8) options.least_sources = options.most_sources;
  const auto most_decisions = static_cast<std::int64_t>(argument(argc, argv, 5, 3e6));
  int known = 0;
  int exact = 0;
  int proven = 0;
  double worst = 0.0;
  for (std::uint64_t seed = first; seed < first + worlds; ++seed) {
    const TaskProblem problem = bench::random_srs_task(seed, options);
    const double begun_ms = thread_cpu_ms();
    TaskPlanner planner{problem, Rng{seed}};
    const double first_value = planner.value();
    const double first_ms = thread_cpu_ms() - begun_ms;
    planner.run(1'000'000'000, [&] { return thread_cpu_ms() - begun_ms >= budget_ms; });
    const double used_ms = thread_cpu_ms() - begun_ms;
    const double value = planner.value();
    const double oracle_begun_ms = thread_cpu_ms();
    bench::OracleResult best{value, 0, planner.is_finished()};
    if (!best.is_complete) {
      best = bench::best_task_value(problem, bench::OraclePruning::Bound, most_decisions, value - 1e-6);
    }
    const double oracle_ms = thread_cpu_ms() - oracle_begun_ms;
    const double gap = best.value > 1e-9 ? (best.value - value) / best.value : 0.0;
    proven += planner.is_finished() ? 1 : 0;
    // A better plan is a miss even where the oracle could not look at everything.
    if (best.is_complete || gap > 1e-6) {
      ++known;
      exact += gap < 1e-6 ? 1 : 0;
      worst = gap > worst ? gap : worst;
    }
    std::printf(
        "%4llu agents=%zu sources=%zu first=%.3f (%.1f ms) value=%.4f bound=%.4f rollouts=%lld %.0f ms %s "
        "oracle=%.4f%s "
        "%lld decisions %.0f ms gap=%.4f%%\n",
        static_cast<unsigned long long>(seed), problem.agents.size(), problem.world.sources.size(), first_value,
        first_ms, value, planner.upper_bound(), static_cast<long long>(planner.rollouts()), used_ms,
        planner.is_finished() ? "proven" : "open", best.value, best.is_complete ? "" : "?",
        static_cast<long long>(best.decisions), oracle_ms, gap * 100.0);
    std::fflush(stdout);
  }
  std::printf("optimum known %d of %llu; exact %d (%.1f %%), worst gap %.2f %%; proven within the budget %d\n", known,
              static_cast<unsigned long long>(worlds), exact, 100.0 * exact / std::max(1, known), worst * 100.0,
              proven);
  return EXIT_SUCCESS;
}
