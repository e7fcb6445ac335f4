#include "bench/planning/loop/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/cpu_clock.hpp"
#include "bench/planning/loop/nearest_unseen_walk.hpp"
#include "bench/planning/oracles/sweep_bound.hpp"

namespace tandem::bench {
namespace {

constexpr double kAllSeenFirstSight = 1e-9;
constexpr double kAllSeenExponential = 1e-4;  ///< what then is left is found one sweep later
constexpr double kLeastStretch_s = 1.0;
constexpr int kFruitlessPlans = 2;  ///< after so many plans on which nothing was seen, the nearest unseen is walked to
constexpr double kLeastFruit = 1e-9;
constexpr double kChangeWindow_s = 30.0;

/// One search under way.
class Loop {
 public:
  Loop(const PlanningInstance& instance, const MakePlanner& make_planner, const LoopOptions& options)
      : instance_(instance), options_(options), rng_(options.seed) {
    double before_ms = thread_cpu_ms();
    world_ = world_of(instance);
    result_.prepare_ms = thread_cpu_ms() - before_ms;
    prior_ = prior_mass(*world_, instance);
    result_.sweep_bound_s = sweep_lower_bound_s(instance, world_->area(), layers_of(instance), prior_);
    before_ms = thread_cpu_ms();
    while (world_->prepare_next()) {
    }
    result_.prepare_ms += thread_cpu_ms() - before_ms;
    std::vector<int> all(instance.searchers.size());
    std::iota(all.begin(), all.end(), 0);
    sweep_s_ = world_->sweep_time_s(all);
    // Who does not share plans alone, each with a planner and a belief of its own.
    const std::size_t groups = options.shares_looks ? 1 : all.size();
    for (std::size_t g = 0; g < groups; ++g) {
      planners_.push_back(make_planner());
      masses_.push_back(prior_);
    }
    for (const Pose2& start : instance.starts) {
      result_.walked.push_back({start, {{{0.0, start.position()}}}});
      poses_.push_back(start);
    }
    current_.resize(all.size());
  }

  LoopResult run() {
    const bool first_sight = std::ranges::all_of(
        instance_.searchers, [](const Searcher& searcher) { return std::isinf(searcher.detection_rate_per_s); });
    const double all_seen = first_sight ? kAllSeenFirstSight : kAllSeenExponential;
    std::vector<double> left = prior_;
    double left_sum = 1.0;
    int fruitless = 0;
    while (now_s_ < instance_.horizon_s && left_sum > all_seen) {
      const bool falls_back = fruitless >= kFruitlessPlans;
      if (falls_back) {
        go_to_unseen(left);
      } else {
        plan_all();
      }
      walk(next_stretch_s(), left);
      const double before = left_sum;
      left_sum = std::accumulate(left.begin(), left.end(), 0.0);
      fruitless = before - left_sum >= kLeastFruit ? 0 : fruitless + 1;
    }
    result_.finished = left_sum <= all_seen;
    result_.duration_s = now_s_;
    result_.score =
        score_of(*world_, prior_, result_.walked, result_.finished ? std::max(now_s_, 1.0) : instance_.horizon_s);
    result_.plan_change_m = changes_ > 0 ? change_sum_m_ / changes_ : 0.0;
    return std::move(result_);
  }

 private:
  [[nodiscard]] SearchProblem problem_of(std::size_t group) const {
    SearchProblem problem;
    problem.world = world_.get();
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      if (!options_.shares_looks && m != group) continue;
      SearchMember member;
      member.searcher = static_cast<int>(m);
      member.pose = poses_[m];
      problem.members.push_back(member);
      if (now_s_ > 0.0) problem.current.push_back(current_[m]);
    }
    problem.masses = {masses_[group]};
    problem.horizon_s = std::max(1.0, std::min(kPlanHorizonSweeps * sweep_s_, instance_.horizon_s - now_s_));
    problem.tail_s = sweep_s_;
    return problem;
  }

  /// Everybody goes to see what is nearest to them.
  void go_to_unseen(const std::vector<double>& left) {
    ++result_.fallbacks;
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      current_[m] = nearest_unseen_walk(*world_, static_cast<int>(m), poses_[m], left);
    }
  }

  /// Plans for everybody; the new paths are in current_.
  void plan_all() {
    for (std::size_t g = 0; g < planners_.size(); ++g) {
      const SearchProblem problem = problem_of(g);
      Planner& planner = *planners_[g];
      const double before_ms = thread_cpu_ms();
      const auto stop = options_.budget.rollouts ? std::function<bool()>([] { return false; })
                                                 : stop_after_cpu_ms(options_.budget.cpu_ms);
      planner.begin(problem, rng_.fork());
      if (now_s_ == 0.0 && g == 0) result_.first_plan_ms = thread_cpu_ms() - before_ms;
      planner.run(options_.budget.rollouts.value_or(std::numeric_limits<int>::max()), stop);
      const JointPlan plan = planner.best();
      result_.replan_ms.push_back(thread_cpu_ms() - before_ms);
      result_.rollouts += planner.rollouts();
      if (now_s_ == 0.0 && g == 0) {
        result_.first_value_s = plan.forecast.expected_time_s;
        result_.first_bound_s = plan.lower_bound_s;
      }
      for (std::size_t i = 0; i < plan.paths.size(); ++i) {
        const std::size_t m = options_.shares_looks ? i : g;
        TimedPath path = plan.paths[i];
        if (path.points.empty()) path.points.push_back({0.0, poses_[m].position()});
        if (now_s_ > 0.0) {
          change_sum_m_ += frechet_distance_m(path, current_[m], kChangeWindow_s);
          ++changes_;
        }
        current_[m] = std::move(path);
      }
    }
  }

  /// Until the next plan: a path ends, or the period is over.
  [[nodiscard]] double next_stretch_s() const {
    double stretch_s = planners_.front()->replans_under_way() ? instance_.replan_period_s : instance_.horizon_s;
    for (const TimedPath& path : current_) {
      if (path.duration_s() > 1e-6) stretch_s = std::min(stretch_s, path.duration_s());
    }
    return std::min(std::max(stretch_s, kLeastStretch_s), instance_.horizon_s - now_s_);
  }

  void walk(double stretch_s, std::vector<double>& left) {
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      const TimedPath piece = cut(current_[m], 0.0, stretch_s);
      const int searcher = static_cast<int>(m);
      const Sightings seen = sightings_along(piece, poses_[m].heading, world_->views(searcher));
      const double rate_per_s = world_->searcher(searcher).detection_rate_per_s;
      take_off_seen(left, seen, rate_per_s, stretch_s);
      take_off_seen(masses_[options_.shares_looks ? 0 : m], seen, rate_per_s, stretch_s);
      append(result_.walked[m], piece);
      poses_[m] = pose_after(piece, poses_[m]);
      current_[m] = cut(current_[m], stretch_s, std::max(stretch_s, current_[m].duration_s()));
    }
    now_s_ += stretch_s;
  }

  const PlanningInstance& instance_;
  const LoopOptions& options_;
  Rng rng_;
  std::unique_ptr<SearchWorld> world_;
  std::vector<double> prior_;
  double sweep_s_ = 0.0;
  std::vector<std::unique_ptr<Planner>> planners_;
  std::vector<std::vector<double>> masses_;  ///< per planner: what it believes
  std::vector<Pose2> poses_;
  std::vector<TimedPath> current_;  ///< per member, from now
  double now_s_ = 0.0;
  double change_sum_m_ = 0.0;
  int changes_ = 0;
  LoopResult result_;
};

}  // namespace

LoopResult played(const PlanningInstance& instance, const MakePlanner& make_planner, const LoopOptions& options) {
  return Loop(instance, make_planner, options).run();
}

}  // namespace tandem::bench
