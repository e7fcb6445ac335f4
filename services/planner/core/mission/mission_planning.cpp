// The part of SearchMission that decides on new plans and makes them.
#include <algorithm>
#include <cmath>
#include <string>

#include "services/planner/core/mission/computation.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kStartReach_m = 3.0;
constexpr double kSurvivalStep_s = 0.5;
constexpr double kPersonForgotten_s = 60.0;  ///< not heard of for so long, a person is planned without
constexpr double kSlackOfPlans = 1.5;        ///< a plan is void after so many times its duration ...
constexpr double kSlack_s = 20.0;            ///< ... and this
constexpr std::size_t kRejectedKept = 4;

/// How far off `path` a point is [m] for one who should be there at `time_s`, or is up to `late_s` late or early.
double distance_to_path_m(const TimedPath& path, const Vector2d& point_in_map, double time_s, double late_s) {
  double nearest_m = (pose_at(path, time_s).position() - point_in_map).norm();
  for (double other_s = time_s - late_s; other_s <= time_s + late_s; other_s += 1.0) {
    nearest_m = std::min(nearest_m, (pose_at(path, other_s).position() - point_in_map).norm());
  }
  return nearest_m;
}

}  // namespace

bool SearchMission::person_is_known(Time now) const {
  return seen_[kPerson] && seen_[kPerson]->age_s + to_seconds(now - seen_[kPerson]->stamp) < kPersonForgotten_s;
}

double SearchMission::elapsed_s(Time now) const {
  return plan_ ? to_seconds(now - plan_->start) : 0.0;
}

PlanSituation SearchMission::situation(Time now) const {
  PlanSituation situation;
  situation.standing = standing(now);
  if (!plan_) return situation;
  situation.age_s = to_seconds(now - proposed_);
  situation.blocked = blocked_since_ && to_seconds(now - *blocked_since_) >= config_.blocked_s;
  situation.robot_finished = robot_finished_;
  situation.goal_reached = person_reached_goal_;
  situation.person_is_new = !person_planned_ && person_is_known(now);
  if (person_off_plan_since_) situation.person_off_plan_s = to_seconds(now - *person_off_plan_since_);
  if (!survival_.empty() && left_when_planned_ > 0.0) {
    const double step = std::max(0.0, (elapsed_s(now) - config_.late_s) / kSurvivalStep_s);
    const auto index = std::min(survival_.size() - 1, static_cast<std::size_t>(step));
    situation.surprise = belief_->probability_left() / left_when_planned_ - survival_[index];
  }
  return situation;
}

void SearchMission::follow_person(Time now) {
  const bool checkable = plan_ && person_planned_ && seen_[kPerson] &&
                         seen_[kPerson]->age_s < config_.person_credit_s && standing(now) == PlanStanding::Accepted;
  const double off_m = checkable
                           ? distance_to_path_m(plan_->members[kPerson].path, seen_[kPerson]->map_from_agent.position(),
                                                elapsed_s(now), config_.late_s)
                           : 0.0;
  if (off_m <= config_.deviation_m) {
    person_off_plan_since_.reset();
  } else if (!person_off_plan_since_) {
    person_off_plan_since_ = now;
  }
}

void SearchMission::drop_reached_goals(Time now) {
  for (const std::size_t member : {kRobot, kPerson}) {
    if (!goals_[member] || !seen_[member] || !plan_ || standing(now) != PlanStanding::Accepted) continue;
    if (member >= plan_->members.size() || !plan_->members[member].goal_fixed) continue;
    const Vector2d& goal = plan_->members[member].goal_in_map;
    if ((seen_[member]->map_from_agent.position() - goal).norm() > config_.goal_reach_m) continue;
    goals_[member].reset();
    ++world_version_;
    if (member == kPerson) person_reached_goal_ = true;
  }
}

void SearchMission::forget_old_blockages(Time now) {
  std::erase_if(blocked_, [&](const auto& entry) { return to_seconds(now - entry.first) > config_.blocked_memory_s; });
}

/// Finds the robot's ways around what is blocked; if that shuts it in, it must try again through what was blocked.
void SearchMission::find_ways_anew(const Vector2d& robot_in_map) {
  std::vector<BlockedDisc> discs;
  for (const auto& entry : blocked_) discs.push_back(entry.second);
  world_->block(kRobot, discs, robot_in_map);
  ++world_version_;
  if (discs.empty()) return;
  ActionSet& actions = world_->actions(kRobot);
  const auto start = actions.add_place(robot_in_map, kStartReach_m);
  if (start && !actions.nearest_lookouts(*start).empty()) return;
  blocked_.clear();
  world_->block(kRobot, {}, robot_in_map);
}

void SearchMission::begin_plan(Time now, const std::string& reason) {
  const Vector2d robot_in_map = seen_[kRobot]->map_from_agent.position();
  const std::size_t remembered = blocked_.size();
  forget_old_blockages(now);
  bool ways_changed = blocked_.size() != remembered;
  if (blocked_since_ && to_seconds(now - *blocked_since_) >= config_.blocked_s) {
    // Not so large that the robot itself stands in it.
    const double room_m = (blocked_at_ - robot_in_map).norm() - 0.2;
    blocked_.emplace_back(now, BlockedDisc{blocked_at_, std::clamp(room_m, 0.3, config_.blocked_radius_m)});
    blocked_since_.reset();
    ways_changed = true;
  }
  if (ways_changed) find_ways_anew(robot_in_map);
  const PlanStanding before = standing(now);
  const bool asked_for = before == PlanStanding::Rejected || before == PlanStanding::Superseded;
  if (!asked_for) rejected_.clear();
  if (rejected_.size() > kRejectedKept) rejected_.erase(rejected_.begin());

  auto computation = std::make_unique<Computation>();
  computation->reason = reason;
  SearchProblem& problem = computation->problem;
  problem.world = world_.get();
  problem.masses = {belief_->posterior()};
  problem.horizon_s = config_.horizon_s;
  problem.rejected = rejected_;
  std::vector<int> searchers;
  for (const std::size_t member : {kRobot, kPerson}) {
    if (member == kPerson && !person_is_known(now)) continue;
    const Pose2& pose = seen_[member]->map_from_agent;
    const int searcher = static_cast<int>(member);
    if (!world_->actions(searcher).can_stand_near(pose.position())) {
      if (member == kPerson) continue;
      failed_ = now;
      return fail("the robot stands where it cannot move");
    }
    SearchMember who;
    who.searcher = searcher;
    who.pose = pose;
    who.goal = goals_[member];
    searchers.push_back(searcher);
    problem.members.push_back(std::move(who));
  }
  problem.tail_s = world_->sweep_time_s(searchers);
  const Rng rng{static_cast<std::uint64_t>(config_.seed) + 1'000'003 * plans_};
  computation->planner = make_planner(config_.planner);
  computation->planner->begin(computation->problem, rng);
  computation_ = std::move(computation);
  activity_ = MissionActivity::Computing;
  failure_.clear();
}

void SearchMission::finish_plan(Time now) {
  const JointPlan joint = computation_->planner->best();
  survival_ = survival_of(computation_->problem, joint.paths, kSurvivalStep_s);
  MissionPlan plan;
  plan.id = session_ + "-" + agents_[kRobot] + "-" + std::to_string(++plans_) + "-" +
            std::to_string(to_stamp_ns(now) / 1'000'000);
  plan.world_version = world_version_;
  plan.start = now + from_seconds(config_.acceptance_delay_s);
  plan.forecast = joint.forecast;
  plan.reason = computation_->reason;
  double duration_s = 0.0;
  for (std::size_t m = 0; m < joint.paths.size(); ++m) {
    const bool goal_fixed = std::isfinite(joint.goal_reached_s[m]);
    const TimedPath path = path_until(joint.paths[m], joint.goal_reached_s[m]);
    plan.members.push_back({agents_[m], path, path.points.back().point_in_map, goal_fixed});
    duration_s = std::max(duration_s, path.duration_s());
  }
  const bool person_fixed = plan.members.size() > kPerson && plan.members[kPerson].goal_fixed;
  plan.role = role_of(person_fixed, plan.members[kRobot].goal_fixed);
  plan.valid_until = plan.start + from_seconds(kSlackOfPlans * duration_s + kSlack_s);
  acceptance_.propose(now, plan.valid_until);
  proposed_ = now;
  left_when_planned_ = belief_->probability_left();
  person_planned_ = plan.members.size() > kPerson;
  plan_ = std::move(plan);
  computation_.reset();
  robot_finished_ = false;
  person_reached_goal_ = false;
  person_off_plan_since_.reset();
  blocked_since_.reset();
  activity_ = MissionActivity::Idle;
}

}  // namespace tandem
