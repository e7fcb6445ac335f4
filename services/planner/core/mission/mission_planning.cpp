// The part of SearchMission that decides on new plans and makes them.
#include <algorithm>
#include <cmath>
#include <string>

#include "services/planner/core/mission/computation.hpp"
#include "services/planner/core/mission/plan_explanation.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kSurvivalStep_s = 0.5;
constexpr double kPersonForgotten_s = 60.0;  ///< not heard of for so long, a person is planned without
constexpr double kSlackOfPlans = 1.5;        ///< a plan is void after so many times its duration ...
constexpr double kSlack_s = 20.0;            ///< ... and this
constexpr std::size_t kRejectedKept = 4;
constexpr double kClearlyAhead_m = 1.0;  ///< of a person whom the robot is to stay behind
constexpr double kLeastStray = 0.05;    ///< a person so unlikely to stray is taken to follow
constexpr double kCourseKept_s = 30.0;  ///< one who strays goes straight on for no longer

/// Where on its path one is.
struct OnPath {
  double time_s = 0.0;      ///< of the nearest place
  double distance_m = 0.0;  ///< to it
};

/// For one who should be at `time_s` of the path, or is up to `late_s` late or early.
OnPath nearest_on(const TimedPath& path, const Vector2d& point_in_map, double time_s, double late_s) {
  OnPath nearest{time_s, (pose_at(path, time_s).position() - point_in_map).norm()};
  for (double other_s = time_s - late_s; other_s <= time_s + late_s; other_s += 1.0) {
    const double distance_m = (pose_at(path, other_s).position() - point_in_map).norm();
    if (distance_m < nearest.distance_m) nearest = {other_s, distance_m};
  }
  return nearest;
}

double length_m(const TimedPath& path) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum_m += (path.points[i].point_in_map - path.points[i - 1].point_in_map).norm();
  }
  return sum_m;
}

std::vector<TimedPath> paths_of(const MissionPlan& plan) {
  std::vector<TimedPath> paths;
  for (const auto& member : plan.members) paths.push_back(member.path);
  return paths;
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
  situation.person_said_where = person_said_where_;
  situation.person_drew = person_drew_;
  situation.edits_must_wait = postponed_;
  situation.person_is_new = !person_planned_ && person_is_known(now);
  situation.robot_is_ahead = keeps_robot_behind(now) && robot_ahead_m() > kClearlyAhead_m;
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
  const double off_m = checkable ? nearest_on(plan_->members[kPerson].path, seen_[kPerson]->map_from_agent.position(),
                                              elapsed_s(now), config_.late_s)
                                       .distance_m
                                 : 0.0;
  habits_.follow(now, checkable ? std::optional{off_m <= config_.deviation_m} : std::nullopt);
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
    forget_drawn_goals(member);
    ++world_version_;
    if (member == kPerson) person_reached_goal_ = true;
  }
}

void SearchMission::forget_old_blockages(Time now) {
  std::erase_if(blocked_, [&](const auto& entry) { return to_seconds(now - entry.first) > config_.blocked_memory_s; });
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
  ways_changed = close_what_is_ahead(now) || ways_changed;
  if (ways_changed) find_ways_around_blockages();
  const PlanStanding before = standing(now);
  const bool asked_for = before == PlanStanding::Rejected || before == PlanStanding::Superseded;
  if (!asked_for) rejected_.clear();
  if (rejected_.size() > kRejectedKept) rejected_.erase(rejected_.begin());

  auto computation = std::make_unique<Computation>();
  computation->reason = reason;
  computation->while_reading = before == PlanStanding::Proposed;
  SearchProblem& problem = computation->problem;
  problem.world = world_.get();
  problem.masses = {belief_->posterior()};
  problem.horizon_s = config_.horizon_s;
  problem.rejected = rejected_;
  problem.current = rest_of_plan(now);
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
    searchers.push_back(searcher);
    problem.members.push_back(member_of_plan(member, now));
    if (member == kRobot && keeps_robot_behind(now) && lead_behind(problem.members.back())) {
      computation->leads_behind = true;
    } else {
      lead_through(problem.members.back());
    }
  }
  problem.tail_s = world_->sweep_time_s(searchers);
  const Rng rng{static_cast<std::uint64_t>(config_.seed) + 1'000'003 * plans_};
  computation->planner = make_planner(config_.planner);
  computation->planner->begin(computation->problem, rng);
  computation_ = std::move(computation);
  activity_ = MissionActivity::Computing;
  failure_.clear();
}

/// What is left of a plan under way or being read, so that the next one is no worse and differs only for something
/// better; nothing if none is.
std::vector<TimedPath> SearchMission::rest_of_plan(Time now) const {
  const PlanStanding before = standing(now);
  const bool was_under_way =
      before == PlanStanding::Accepted || before == PlanStanding::Superseded || before == PlanStanding::Proposed;
  std::vector<TimedPath> rest;
  if (!plan_ || !was_under_way) return rest;
  for (std::size_t m = 0; m < plan_->members.size(); ++m) {
    rest.push_back(rest_of(plan_->members[m].path, std::max(0.0, elapsed_s(now)), seen_[m]->map_from_agent.position()));
  }
  return rest;
}

/// One who is planned for. A person does not turn to a new plan at once, unless they asked for it; and one who has not
/// followed plans may go straight on instead.
SearchMember SearchMission::member_of_plan(std::size_t member, Time now) const {
  SearchMember who;
  who.searcher = static_cast<int>(member);
  who.pose = seen_[member]->map_from_agent;
  who.goal = goals_[member];
  if (member != kPerson) return who;
  const Vector2d person_in_map = who.pose.position();
  const bool goes_on = plan_ && person_planned_ && standing(now) == PlanStanding::Accepted && !person_off_plan_since_;
  if (goes_on && !person_said_where_ && !person_drew_) {
    const TimedPath& path = plan_->members[kPerson].path;
    const double on_path_s = nearest_on(path, person_in_map, elapsed_s(now), config_.late_s).time_s;
    const TimedPath rest = rest_of(path, on_path_s, person_in_map);
    if (rest.points.size() > 1) who.committed = path_until(rest, config_.person_reaction_s);
  }
  const double stray = habits_.stray_probability();
  if (stray < kLeastStray) return who;
  const Searcher& person = world_->searcher(who.searcher);
  const TimedPath astray = straight_on(world_->actions(who.searcher).motion(), person_in_map, habits_.course(),
                                       person.speed_mps, person.radius_m, kCourseKept_s);
  who.hypotheses.push_back({stray, waiting_until(astray, config_.horizon_s)});
  return who;
}

std::string SearchMission::explanation(const JointPlan& joint, const MissionPlan& plan) const {
  PlanFacts facts;
  facts.occasion = plan.reason;
  facts.robot_way_m = length_m(plan.members[kRobot].path);
  facts.robot_goal_fixed = plan.members[kRobot].goal_fixed;
  facts.probability_found = joint.forecast.probability_found;
  facts.horizon_s = config_.horizon_s;
  if (plan.members.size() > kPerson) {
    facts.person_way_m = length_m(plan.members[kPerson].path);
    facts.person_goal_fixed = plan.members[kPerson].goal_fixed;
    std::vector<TimedPath> paths = joint.paths;
    paths[kPerson] = waiting_until({{paths[kPerson].points.front()}}, config_.horizon_s);
    const JointPlan person_stays = evaluated(computation_->problem, std::move(paths));
    facts.without_person_s = person_stays.forecast.expected_time_s - joint.forecast.expected_time_s;
  }
  return explanation_of(facts);
}

/// Shows the plan to the team. One that begins like the plan they are reading is accepted when that would have been.
void SearchMission::propose(MissionPlan plan, double duration_s, Time now) {
  const bool in_place_of_a_proposal = plan_ && computation_->while_reading && standing(now) != PlanStanding::Rejected &&
                                      standing(now) != PlanStanding::Superseded;
  const bool begins_alike = in_place_of_a_proposal && plan_->members.size() == plan.members.size() &&
                            is_like(paths_of(plan), paths_of(*plan_));
  if (!begins_alike) {
    proposed_ = now;
    postponed_ = in_place_of_a_proposal && (person_said_where_ || person_drew_);
  }
  plan.start = std::max(now, proposed_ + from_seconds(config_.acceptance_delay_s));
  plan.valid_until = plan.start + from_seconds(kSlackOfPlans * duration_s + kSlack_s);
  acceptance_.propose(proposed_, plan.valid_until);
  plan_ = std::move(plan);
}

void SearchMission::stop_computing() {
  computation_.reset();
  certifiable_.reset();
}

bool SearchMission::certify() {
  if (!certifiable_) return false;
  plan_->lower_bound_s = certifiable_->planner->lower_bound_s();
  certifiable_.reset();
  return true;
}

void SearchMission::finish_plan(Time now) {
  const JointPlan joint = computation_->planner->best();
  survival_ = survival_of(computation_->problem, joint.paths, kSurvivalStep_s);
  MissionPlan plan;
  plan.id = session_ + "-" + agents_[kRobot] + "-" + std::to_string(++plans_) + "-" +
            std::to_string(to_stamp_ns(now) / 1'000'000);
  plan.world_version = world_version_;
  plan.forecast = joint.forecast;
  plan.reason = computation_->reason;
  double duration_s = 0.0;
  for (std::size_t m = 0; m < joint.paths.size(); ++m) {
    const bool leads_behind = m == kRobot && computation_->leads_behind;
    const bool goal_fixed = std::isfinite(joint.goal_reached_s[m]) && !leads_behind;
    const double end_s =
        leads_behind ? computation_->problem.members[m].committed.duration_s() : joint.goal_reached_s[m];
    const TimedPath path = path_until(joint.paths[m], end_s);
    plan.members.push_back({agents_[m], path, path.points.back().point_in_map, goal_fixed});
    duration_s = std::max(duration_s, path.duration_s());
  }
  const bool person_fixed = plan.members.size() > kPerson && plan.members[kPerson].goal_fixed;
  plan.role = role_of(person_fixed, plan.members[kRobot].goal_fixed);
  plan.explanation = explanation(joint, plan);
  propose(std::move(plan), duration_s, now);
  left_when_planned_ = belief_->probability_left();
  person_planned_ = plan_->members.size() > kPerson;
  if (!computation_->overtaken) {
    person_said_where_ = false;
    person_drew_ = false;
  }
  certifiable_ = std::move(computation_);
  begun_anew_ = false;
  robot_finished_ = false;
  person_reached_goal_ = false;
  person_off_plan_since_.reset();
  blocked_since_.reset();
  activity_ = MissionActivity::Idle;
}

}  // namespace tandem
