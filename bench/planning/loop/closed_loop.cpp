#include "bench/planning/loop/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/cpu_clock.hpp"
#include "bench/planning/loop/nearest_unseen_walk.hpp"
#include "bench/planning/loop/person_walk.hpp"
#include "bench/planning/loop/world_events.hpp"
#include "bench/planning/oracles/sweep_bound.hpp"

namespace tandem::bench {
namespace {

constexpr double kAllSeenFirstSight = 1e-9;
constexpr double kAllSeenExponential = 1e-4;  ///< what then is left is found one sweep later
constexpr double kLeastStretch_s = 1.0;
/// The nearest unseen is walked to if a plan promises nothing, and if nothing was seen for so long.
constexpr double kLeastPatience_s = 30.0;
constexpr double kPatiencePeriods = 3.0;
constexpr double kLeastFruit = 1e-9;
constexpr double kChangeWindow_s = 30.0;
constexpr double kReaction_s = 5.0;  ///< A person who reads a new plan goes on so long as before.
constexpr double kPassing_s = 3.0;   ///< So long one waits for a passer-by.

/// Who plan together, with what they believe.
struct Group {
  std::unique_ptr<Planner> planner;
  std::vector<std::size_t> members;
  std::vector<double> mass;
  bool hears_all = true;  ///< what others see, too
};

/// One search under way.
class Loop {
 public:
  Loop(const PlanningInstance& instance, const MakePlanner& make_planner, const LoopOptions& options)
      : instance_(instance), options_(options), rng_(options.seed) {
    double before_ms = thread_cpu_ms();
    world_ = world_of(instance);
    result_.prepare_ms = thread_cpu_ms() - before_ms;
    const std::vector<double> prior = prior_mass(*world_, instance);
    result_.sweep_bound_s = sweep_lower_bound_s(instance, world_->area(), layers_of(instance), prior);
    before_ms = thread_cpu_ms();
    while (world_->prepare_next()) {
    }
    result_.prepare_ms += thread_cpu_ms() - before_ms;
    std::vector<int> all(instance.searchers.size());
    std::iota(all.begin(), all.end(), 0);
    sweep_s_ = world_->sweep_time_s(all);
    for (const Pose2& start : instance.starts) {
      result_.walked.push_back({start, {{{0.0, start.position()}}}});
      poses_.push_back(start);
      current_.push_back({{{0.0, start.position()}}});
      waits_until_s_.push_back(0.0);
    }
    person_ = person_of(instance);
    if (!instance.human.empty() && options.person == PersonIs::Planned) {
      person_walk_ = std::make_unique<PersonWalk>(instance, world_->map(0), person_, rng_.bits());
    }
    form_groups(make_planner, prior);
    left_ = scored_prior_ = prior;
    // A hint is right on average: who is scored had it in the truth from the beginning.
    for (const WorldEvent& event : instance.events) {
      if (event.kind == WorldEvent::Kind::Hint) take_hint(scored_prior_, world_->area(), event);
    }
  }

  LoopResult run() {
    const bool first_sight = std::ranges::all_of(
        instance_.searchers, [](const Searcher& searcher) { return std::isinf(searcher.detection_rate_per_s); });
    const double all_seen = first_sight ? kAllSeenFirstSight : kAllSeenExponential;
    double left_sum = 1.0;
    double seen_last_s = 0.0;
    while (now_s_ < instance_.horizon_s && left_sum > all_seen) {
      const double patience_s = std::max(kLeastPatience_s, kPatiencePeriods * instance_.replan_period_s);
      if (now_s_ - seen_last_s > patience_s || !plan_all()) go_to_unseen();
      walk(next_stretch_s());
      const double before = left_sum;
      left_sum = std::accumulate(left_.begin(), left_.end(), 0.0);
      if (before - left_sum >= kLeastFruit) seen_last_s = now_s_;
    }
    result_.finished = left_sum <= all_seen;
    result_.duration_s = now_s_;
    result_.score = score_of(*world_, scored_prior_, result_.walked,
                             result_.finished ? std::max(now_s_, 1.0) : instance_.horizon_s);
    result_.plan_change_m = changes_ > 0 ? change_sum_m_ / changes_ : 0.0;
    return std::move(result_);
  }

 private:
  /// Who does not share plans alone, each with a planner and a belief of its own.
  void form_groups(const MakePlanner& make_planner, const std::vector<double>& prior) {
    std::vector<std::size_t> planned;
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      if (options_.person == PersonIs::Planned || m != person_) planned.push_back(m);
    }
    const bool hears_all = options_.shares_looks && options_.person != PersonIs::Ignored;
    if (options_.shares_looks) {
      groups_.push_back({make_planner(), planned, prior, hears_all});
      return;
    }
    for (const std::size_t m : planned) groups_.push_back({make_planner(), {m}, prior, hears_all});
  }

  [[nodiscard]] SearchProblem problem_of(const Group& group) const {
    SearchProblem problem;
    problem.world = world_.get();
    for (const std::size_t m : group.members) {
      SearchMember member;
      member.searcher = static_cast<int>(m);
      member.pose = poses_[m];
      member.battery_s = battery_s(m);
      if (m == person_ && person_walk_) {
        member.goal = person_walk_->goal();
        if (now_s_ > 0.0) member.committed = person_walk_->under_way(kReaction_s);
      } else if (waits_until_s_[m] > now_s_) {
        member.committed.points = {{0.0, poses_[m].position()}, {waits_until_s_[m] - now_s_, poses_[m].position()}};
      }
      problem.members.push_back(member);
      if (now_s_ > 0.0) problem.current.push_back(current_[m]);
    }
    if (options_.person == PersonIs::Known) {
      const double end_s = std::max(now_s_ + 1.0, options_.person_path.duration_s());
      problem.others.push_back(
          {static_cast<int>(person_), poses_[person_].heading, cut(options_.person_path, now_s_, end_s)});
    }
    problem.masses = {group.mass};
    problem.horizon_s = std::max(1.0, std::min(kPlanHorizonSweeps * sweep_s_, instance_.horizon_s - now_s_));
    problem.tail_s = sweep_s_;
    problem.rejected = rejected_;
    return problem;
  }

  /// How long a member can still go on.
  [[nodiscard]] double battery_s(std::size_t member) const {
    return std::max(0.0, instance_.searchers[member].endurance_s - now_s_);
  }

  /// Everybody goes to see what is nearest to them.
  void go_to_unseen() {
    ++result_.fallbacks;
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      current_[m] = path_until(nearest_unseen_walk(*world_, static_cast<int>(m), poses_[m], left_), battery_s(m));
    }
  }

  /// Plans for everybody; the new paths are in current_. Whether they promise to see anything new.
  bool plan_all() {
    bool promises = false;
    for (Group& group : groups_) {
      const bool is_first = now_s_ == 0.0 && &group == &groups_.front();
      const SearchProblem problem = problem_of(group);
      const double before_ms = thread_cpu_ms();
      const auto stop = options_.budget.rollouts ? std::function<bool()>([] { return false; })
                                                 : stop_after_cpu_ms(options_.budget.cpu_ms);
      group.planner->begin(problem, rng_.fork());
      if (is_first) result_.first_plan_ms = thread_cpu_ms() - before_ms;
      group.planner->run(options_.budget.rollouts.value_or(std::numeric_limits<int>::max()), stop);
      const JointPlan plan = group.planner->best();
      result_.replan_ms.push_back(thread_cpu_ms() - before_ms);
      result_.rollouts += group.planner->rollouts();
      if (is_first) {
        result_.first_value_s = plan.forecast.expected_time_s;
        result_.first_bound_s = group.planner->lower_bound_s();
      }
      result_.repeated += std::ranges::any_of(rejected_, [&](const auto& r) { return is_like(plan.paths, r); }) ? 1 : 0;
      promises = promises || plan.forecast.probability_found > kLeastFruit;
      for (std::size_t i = 0; i < plan.paths.size(); ++i) take_up(group.members[i], plan.paths[i]);
    }
    rejected_.clear();
    return promises;
  }

  void take_up(std::size_t member, TimedPath path) {
    if (path.points.empty()) path.points.push_back({0.0, poses_[member].position()});
    if (now_s_ > 0.0) {
      change_sum_m_ += frechet_distance_m(path, current_[member], kChangeWindow_s);
      ++changes_;
    }
    if (member == person_ && person_walk_) person_walk_->show_plan(path);
    current_[member] = std::move(path);
  }

  /// Until the next plan: a path ends, the period is over, or the world changes.
  [[nodiscard]] double next_stretch_s() const {
    double stretch_s = groups_.front().planner->replans_under_way() ? instance_.replan_period_s : instance_.horizon_s;
    for (const TimedPath& path : current_) {
      if (path.duration_s() > 1e-6) stretch_s = std::min(stretch_s, path.duration_s());
    }
    stretch_s = std::max(stretch_s, kLeastStretch_s);
    for (const WorldEvent& event : instance_.events) {
      if (event.time_s > now_s_) stretch_s = std::min(stretch_s, event.time_s - now_s_);
    }
    return std::min(stretch_s, instance_.horizon_s - now_s_);
  }

  void walk(double stretch_s) {
    if (person_walk_) {
      current_[person_] = person_walk_->walk(stretch_s, kLeastStretch_s);
      stretch_s = current_[person_].duration_s();
    } else if (options_.person != PersonIs::Planned) {
      current_[person_] = cut(options_.person_path, now_s_, now_s_ + stretch_s);
    }
    for (std::size_t m = 0; m < poses_.size(); ++m) {
      const TimedPath piece = cut(current_[m], 0.0, stretch_s);
      const int searcher = static_cast<int>(m);
      const Sightings seen = sightings_along(piece, poses_[m].heading, world_->views(searcher));
      const double rate_per_s = world_->searcher(searcher).detection_rate_per_s;
      take_off_seen(left_, seen, rate_per_s, stretch_s);
      for (Group& group : groups_) {
        const bool is_own = std::ranges::find(group.members, m) != group.members.end();
        if (is_own || group.hears_all) take_off_seen(group.mass, seen, rate_per_s, stretch_s);
      }
      append(result_.walked[m], piece);
      poses_[m] = pose_after(piece, poses_[m]);
      current_[m] = cut(current_[m], stretch_s, std::max(stretch_s, current_[m].duration_s()));
    }
    now_s_ += stretch_s;
    for (const WorldEvent& event : instance_.events) {
      if (std::abs(event.time_s - now_s_) < 1e-6) happen(event);
    }
  }

  void happen(const WorldEvent& event) {
    switch (event.kind) {
      case WorldEvent::Kind::BlockedPassage:
        for (std::size_t m = 0; m < poses_.size(); ++m) {
          world_->block(static_cast<int>(m), {{event.centre_in_map, event.radius_m}}, poses_[m].position());
        }
        break;
      case WorldEvent::Kind::Hint:
        take_hint(left_, world_->area(), event);
        for (Group& group : groups_) take_hint(group.mass, world_->area(), event);
        break;
      case WorldEvent::Kind::RejectedPlan:
        rejected_.push_back(current_);
        break;
      case WorldEvent::Kind::Passer:
        for (std::size_t m = 0; m < poses_.size(); ++m) {
          const bool is_near = (poses_[m].position() - event.centre_in_map).norm() <= event.radius_m;
          if (is_near) waits_until_s_[m] = now_s_ + kPassing_s;
        }
        break;
    }
  }

  const PlanningInstance& instance_;
  const LoopOptions& options_;
  Rng rng_;
  std::unique_ptr<SearchWorld> world_;
  double sweep_s_ = 0.0;
  std::size_t person_ = 0;                   ///< the first person; as many as there are searchers: none
  std::unique_ptr<PersonWalk> person_walk_;  ///< none: the person walks its plan to the letter
  std::vector<Group> groups_;
  std::vector<double> scored_prior_;
  std::vector<double> left_;  ///< of the prior
  std::vector<Pose2> poses_;
  std::vector<TimedPath> current_;  ///< per member, from now
  std::vector<double> waits_until_s_;
  std::vector<std::vector<TimedPath>> rejected_;
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
