#include "services/planner/core/mission/search_mission.hpp"

#include <algorithm>
#include <utility>

#include "services/planner/core/mission/computation.hpp"
#include "services/planner/core/mission/mission_world.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kGoalOffArea_m = 3.0;  ///< a goal may lie this far off the floor: the nearest floor is meant
constexpr double kMostlyNew_s = 10.0;   ///< Replan within this of a plan's acceptance still means: not like this

}  // namespace

SearchMission::SearchMission(const PlannerConfig& config, std::string robot, std::string person)
    : config_(config),
      agents_{std::move(robot), std::move(person)},
      watches_{Watch{kRobot, robot_of(config, agents_[kRobot])}, Watch{kPerson, person_of(config, agents_[kPerson])}},
      acceptance_(from_seconds(config.acceptance_delay_s)),
      habits_(config.person_trust_s),
      informs_({config.inform_cost_s, config.inform_pause_s, config.inform_life_s}) {}

SearchMission::~SearchMission() = default;

void SearchMission::set_map(OccupancyGrid map, std::vector<MapArea> zones) {
  if (map_ && *map_ == map) return;
  map_ = std::move(map);
  zones_ = std::move(zones);
  stop_computing();
  world_.reset();
  drawn_.clear();
  belief_.reset();
  knowledge_.reset();
  inform_.reset();
  plan_.reset();
  acceptance_.clear();
  ++world_version_;
}

void SearchMission::run_session(const std::string& code, Time now) {
  if (running_ && session_ == code) return;
  session_ = code;
  running_ = true;
  running_since_ = now;
  start_search();
}

void SearchMission::end_session() {
  running_ = false;
  stop_computing();
  acceptance_.withdraw();
  if (activity_ != MissionActivity::Finished) activity_ = MissionActivity::Idle;
}

/// A new search: everything is unexplored again, nobody has asked for anything, and chance begins anew.
void SearchMission::start_search() {
  stop_computing();
  plan_.reset();
  acceptance_.clear();
  rejected_.clear();
  blocked_since_.reset();
  plans_ = 0;
  goals_ = {};
  forget_drawn();
  person_said_where_ = false;
  begun_anew_ = false;
  postponed_ = false;
  habits_ = PersonHabits(config_.person_trust_s);
  for (auto& watch : watches_) watch.pause();
  activity_ = MissionActivity::Idle;
  failure_.clear();
  if (world_ && seen_[kRobot]) {
    belief_.emplace(uniform_prior(world_->area(), seen_[kRobot]->map_from_agent.position(), config_.excluded_radius_m));
    begin_knowledge();
  }
}

void SearchMission::robot_at(Time stamp, const Pose2& map_from_robot) {
  seen_[kRobot] = Seen{stamp, map_from_robot, 0.0};
  if (running_ && belief_ && activity_ != MissionActivity::Finished) {
    watches_[kRobot].look(stamp, map_from_robot, world_->observability(0), *belief_);
    knowledge_->robot_looks(stamp, map_from_robot, world_->observability(0));
  }
}

void SearchMission::person_at(Time stamp, const Pose2& map_from_person, double age_s) {
  seen_[kPerson] = Seen{stamp, map_from_person, age_s};
  if (age_s < config_.person_credit_s) habits_.seen(stamp, map_from_person.position());
  if (age_s >= config_.person_credit_s) {
    watches_[kPerson].pause();
    if (knowledge_) knowledge_->person_is_lost();
  } else if (running_ && belief_ && activity_ != MissionActivity::Finished) {
    watches_[kPerson].look(stamp, map_from_person, world_->observability(0), *belief_);
    knowledge_->person_looks(stamp, map_from_person, world_->observability(0));
  }
}

std::optional<std::string> SearchMission::request(const PersonRequest& request, Time now) {
  using Kind = PersonRequest::Kind;
  const std::size_t whose = request.kind == Kind::RobotGoal || request.kind == Kind::ClearRobotGoal ? kRobot : kPerson;
  switch (request.kind) {
    case Kind::MyPose:
      return std::nullopt;  // the tracker's; known here as the person's pose
    case Kind::ClearMyGoal:
    case Kind::ClearRobotGoal:
      goals_[whose].reset();
      forget_drawn_goals(whose);
      ++world_version_;
      return std::nullopt;
    case Kind::MyGoal:
    case Kind::RobotGoal: {
      if (!world_) return "the map is not known yet";
      const auto cell = world_->area().nearest_cell(request.point_in_map, kGoalOffArea_m);
      if (!cell) return "there is no floor to stand on near that place";
      forget_drawn_goals(whose);
      const bool on_floor = world_->area().cell_at(request.point_in_map).has_value();
      goals_[whose] = on_floor ? request.point_in_map : world_->area().point(*cell);
      ++world_version_;
      return std::nullopt;
    }
    case Kind::Replan:
      break;
  }
  if (!running_) return "the search has not begun";
  if (activity_ == MissionActivity::Finished) return "the search is over";
  const bool is_rejection = standing(now) == PlanStanding::Proposed ||
                            (standing(now) == PlanStanding::Accepted &&
                             to_seconds(now - proposed_) < config_.acceptance_delay_s + kMostlyNew_s);
  if (plan_ && is_rejection) {
    std::vector<TimedPath> paths;
    for (const auto& member : plan_->members) paths.push_back(member.path);
    rejected_.push_back(std::move(paths));
  }
  acceptance_.replan(now);
  stop_computing();  // what was being computed did not know of this
  return std::nullopt;
}

void SearchMission::robot_progress(const RobotProgress& progress, Time now) {
  if (!plan_ || progress.plan_id != plan_->id) return;
  robot_finished_ = progress.finished;
  if (!progress.blocked) {
    blocked_since_.reset();
  } else if (!blocked_since_) {
    blocked_since_ = now;
    blocked_at_ = progress.blocked_at_in_map;
  }
}

void SearchMission::found() {
  activity_ = MissionActivity::Finished;
  stop_computing();
  acceptance_.withdraw();
}

bool SearchMission::step(Time now, const std::function<bool()>& slice_over) {
  certifiable_.reset();
  prepare();
  if (world_ && !computation_) {
    while (!slice_over() && world_->prepare_next()) continue;
  }
  if (!running_ || !world_ || activity_ == MissionActivity::Finished) return false;
  follow_person(now);
  drop_reached_goals(now);
  drop_passed_places();
  if (!computation_) {
    const bool person_may_come =
        !plan_ && !person_is_known(now) && to_seconds(now - running_since_) < config_.wait_for_person_s;
    const bool failed_just_now = activity_ == MissionActivity::Failed && to_seconds(now - failed_) < 2.0;
    if (person_may_come || failed_just_now) return false;
    const auto reason = replan_reason(situation(now), config_);
    if (!reason) {
      consider_informing(now);
      return false;
    }
    begin_plan(now, *reason);
    if (!computation_) return false;
  }
  const auto budget = static_cast<int>(config_.rollouts);
  computation_->planner->run(budget - computation_->planner->rollouts(), slice_over);
  if (computation_->planner->rollouts() < budget) return false;
  finish_plan(now);
  return true;
}

bool SearchMission::conclude(Time now) {
  if (!computation_) return false;
  finish_plan(now);
  return true;
}

double SearchMission::progress() const {
  if (!computation_ || config_.rollouts == 0) return computation_ ? 0.0 : 1.0;
  return static_cast<double>(computation_->planner->rollouts()) / static_cast<double>(config_.rollouts);
}

ExploredShares SearchMission::explored() const {
  if (!world_ || !belief_) return {0.0, {0.0, 0.0}};
  return explored_shares(world_->area(), *belief_, agents_.size(), config_.explored_probability);
}

/// Builds what depends on map and start, once both are known.
void SearchMission::prepare() {
  if (world_ || !map_ || !seen_[kRobot]) return;
  const Vector2d start = seen_[kRobot]->map_from_agent.position();
  auto world = search_world(*map_, zones_, search_world_options(config_, agents_[kRobot], agents_[kPerson], start));
  if (world->area().size() == 0) {
    fail("there is no floor to search around the robot");
    map_.reset();  // until another one comes
    return;
  }
  world_ = std::move(world);
  belief_.emplace(uniform_prior(world_->area(), start, config_.excluded_radius_m));
  begin_knowledge();
}

void SearchMission::fail(const std::string& why) {
  activity_ = MissionActivity::Failed;
  failure_ = why;
}

}  // namespace tandem
