#include "services/experiment/core/episode/episode.hpp"

#include <cmath>
#include <utility>

#include "services/experiment/core/episode/person_watch.hpp"
#include "services/mapping/core/ray_casting.hpp"
#include "services/planner/core/mission/mission_world.hpp"
#include "services/simulator/core/walker.hpp"

namespace tandem::experiment {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.1;
constexpr int kStepsPerPlanning = 2;  ///< the planner is told and asked every so many steps
constexpr Duration kPlanPeriod = std::chrono::seconds{1};
constexpr Duration kBeliefPeriod = std::chrono::seconds{1};
constexpr Duration kBetweenEpisodes = std::chrono::hours{1};
constexpr double kRobotRadius_m = 0.4;
constexpr double kLookAround_radps = 0.3;

navigator::NavigatorConfig in_steps(navigator::NavigatorConfig config) {
  config.period_s = kStep_s;
  return config;
}

std::vector<Vector2d> points_of(const TimedPath& path) {
  std::vector<Vector2d> points;
  points.reserve(path.points.size());
  for (const auto& point : path.points) points.push_back(point.point_in_map);
  return points;
}

}  // namespace

/// One episode under way.
class Episode {
 public:
  Episode(EpisodeWorld& world, std::string_view human, std::uint64_t seed, const std::optional<PlanningTime>& time,
          EpisodeObserver* observer)
      : world_(world),
        time_(time),
        observer_(observer),
        scene_(simulator::scene_of(world.scenario_, world.place_, simulator::MapChoice::OwnMap, seed)),
        token_(middle_of(scene_.tokens_in_map)),
        rng_(seed),
        human_rng_(rng_.fork()),
        detection_rng_(rng_.fork()),
        human_(make_human(human, world.person_world_, world.options_.planner.person_speed_mps)),
        walker_(scene_.person_start),
        drive_(in_steps(world.options_.navigator), world.options_.slip, scene_.robot_start, rng_.fork()),
        watch_(world.options_.tracking, rng_.fork()),
        robot_eye_(robot_of(world.options_.planner, "robot")),
        human_eye_(person_of(world.options_.planner, "human")) {
    for (std::int64_t i = 0; i < world.scenario_.passers_by && !world.ground_.empty(); ++i) {
      passers_by_.emplace_back(world.ground_, rng_.fork());
    }
    world_.now_ += kBetweenEpisodes;
    began_ = world_.now_;
    session_ = "study-" + std::to_string(++world_.played_);
    result_.seed = seed;
  }

  std::optional<EpisodeResult> play(const std::function<bool()>& stop) {
    world_.mission_.robot_at(now(), drive_.map_from_base());
    world_.mission_.run_session(session_, now());
    if (observer_ != nullptr) observer_->began(now(), session_, token_);
    const auto steps = static_cast<std::int64_t>(std::lround(world_.scenario_.limit_s / kStep_s));
    for (std::int64_t step = 0; step < steps && !result_.found; ++step) {
      if (stop && stop()) {
        world_.mission_.end_session();
        return std::nullopt;
      }
      if (step % kStepsPerPlanning == 0) plan();
      use_phone();
      move();
      look();
      if (observer_ != nullptr) tell_observer();
    }
    finish();
    return std::move(result_);
  }

 private:
  static Vector2d middle_of(const std::array<Vector2d, 3>& tokens) { return (tokens[0] + tokens[1] + tokens[2]) / 3.0; }
  [[nodiscard]] Time now() const { return world_.now_; }
  [[nodiscard]] double elapsed_s() const { return to_seconds(now() - began_); }

  void plan() {
    SearchMission& mission = world_.mission_;
    mission.robot_at(now(), drive_.map_from_base());
    if (const auto person = watch_.estimate(now())) {
      mission.person_at(now(), person->map_from_agent, person->lost ? person->age_s : 0.0);
    }
    const navigator::Execution& execution = drive_.execution();
    mission.robot_progress({execution.plan_id, execution.finished, execution.blocked, execution.blocked_at_in_map},
                           now());
    if (time_) time_->begin();
    const bool is_new = mission.step(
                            now(), time_ ? time_->is_over : [] { return false; }) ||
                        conclude();
    if (is_new) {
      ++result_.plans;
      const Role role = mission.plan()->role;
      if (result_.roles.empty() || result_.roles.back().role != role) result_.roles.push_back({elapsed_s(), role});
    }
    tell_plan();
  }

  /// The time for a plan that is being computed is up.
  bool conclude() { return time_ && world_.mission_.conclude(now()); }

  /// To the robot, the phone and the tracker.
  void tell_plan() {
    SearchMission& mission = world_.mission_;
    if (!mission.plan()) return;
    const MissionPlan& plan = *mission.plan();
    const PlanStanding standing = mission.standing(now());
    const bool holds = standing == PlanStanding::Proposed || standing == PlanStanding::Accepted;
    const bool is_news = plan.id != told_plan_ || standing != told_standing_;
    may_move_ = standing == PlanStanding::Accepted;
    if (!is_news && (!holds || now() < tell_again_)) return;
    if (is_news && observer_ != nullptr) observer_->planned(now(), plan, standing);
    told_plan_ = plan.id;
    told_standing_ = standing;
    tell_again_ = now() + kPlanPeriod;

    const auto state = standing == PlanStanding::Accepted   ? navigator::PlanState::Accepted
                       : standing == PlanStanding::Proposed ? navigator::PlanState::Proposed
                       : standing == PlanStanding::Rejected ? navigator::PlanState::Rejected
                                                            : navigator::PlanState::Superseded;
    drive_.hear({plan.id, session_, "planner", ++sequence_number_, state, plan.valid_until,
                 points_of(plan.members[SearchMission::kRobot].path)},
                now());
    if (!is_news) return;
    const bool has_person = plan.members.size() > SearchMission::kPerson;
    const auto own_path = has_person ? points_of(plan.members[SearchMission::kPerson].path) : std::vector<Vector2d>{};
    phone_plan_.reset();
    if (holds && has_person) phone_plan_ = simulator::PhonePlan{plan.id, own_path};
    watch_.follow(standing == PlanStanding::Accepted ? own_path : std::vector<Vector2d>{});
  }

  void use_phone() {
    simulator::PhoneUserInput input;
    input.now = now();
    input.dt_s = kStep_s;
    input.map_from_person = walker_.map_from_person();
    input.walking = !route_.finished();
    input.connected = true;
    input.replan_refused = replan_refused_;
    input.plan = phone_plan_;
    auto decision = human_.mind->step(input, human_rng_);
    if (decision.new_route_in_map) route_ = simulator::Route{std::move(*decision.new_route_in_map)};
    for (const auto& message : decision.messages) press(message);
  }

  void press(const simulator::PhoneMessage& message) {
    using simulator::PhonePress;
    if (observer_ != nullptr) observer_->pressed(now(), message);
    switch (message.press) {
      case PhonePress::MyPose:
        ++result_.messages["my_pose"];
        watch_.hear(now(), message);
        break;
      case PhonePress::MyGoal:
        ++result_.messages["my_goal"];
        (void)world_.mission_.request({PersonRequest::Kind::MyGoal, message.point_in_map.value_or(Vector2d::Zero())},
                                      now());
        break;
      case PhonePress::Replan:
        ++result_.messages["replan"];
        replan_refused_ = world_.mission_.request({PersonRequest::Kind::Replan, {}}, now()).has_value();
        break;
      case PhonePress::Found:
        break;  // look() decides on that
    }
  }

  void move() {
    world_.now_ += from_seconds(kStep_s);
    std::vector<Bystander> people{bystander(walker_)};
    for (const auto& passer_by : passers_by_) people.push_back(bystander(passer_by.walker()));
    drive_.step(now(), session_, may_move_, world_.place_, people);

    const simulator::Disc robot{drive_.map_from_base().position(), kRobotRadius_m};
    for (std::size_t i = 0; i < passers_by_.size(); ++i) {
      std::vector<simulator::Disc> others{robot, walker_.body()};
      for (std::size_t j = 0; j < passers_by_.size(); ++j) {
        if (j != i) others.push_back(passers_by_[j].walker().body());
      }
      passers_by_[i].step(kStep_s, world_.place_, world_.ground_, others);
    }
    std::vector<simulator::Disc> others{robot};
    for (const auto& passer_by : passers_by_) others.push_back(passer_by.walker().body());
    const Vector2d before = walker_.map_from_person().position();
    if (route_.finished()) {
      walker_.stand(kLookAround_radps, kStep_s);
    } else {
      route_.follow(walker_, human_.speed_mps, kStep_s, world_.place_, others);
    }
    result_.human_distance_m += (walker_.map_from_person().position() - before).norm();
  }

  void look() {
    std::vector<Vector2d> people{walker_.map_from_person().position()};
    for (const auto& passer_by : passers_by_) people.push_back(passer_by.walker().map_from_person().position());
    watch_.see(now(), world_.place_.map(), drive_.map_from_base(), people);
    if (detects(robot_eye_, drive_.map_from_base())) found_by("robot");
    if (!result_.found && detects(human_eye_, walker_.map_from_person())) found_by("human");
  }

  /// The model of the planner, at the place where the tokens truly are: at a constant rate while they are in view.
  bool detects(const Searcher& eye, const Pose2& map_from_eye) {
    const Vector2d away = token_ - map_from_eye.position();
    const double distance_m = away.norm();
    if (distance_m < eye.view_min_m || distance_m > eye.view_max_m) return false;
    const double bearing_rad = turn_between(map_from_eye.heading, std::atan2(away.y(), away.x()));
    if (std::abs(bearing_rad) > 0.5 * eye.field_of_view_rad) return false;
    if (!line_of_sight(world_.place_.map(), map_from_eye.position(), token_)) return false;
    return detection_rng_.uniform() < -std::expm1(-eye.detection_rate_per_s * kStep_s);
  }

  void found_by(const std::string& who) {
    result_.found = true;
    result_.found_by = who;
  }

  void tell_observer() {
    std::vector<Pose2> others;
    for (const auto& passer_by : passers_by_) others.push_back(passer_by.walker().map_from_person());
    observer_->stood(now(), drive_.map_from_base(), walker_.map_from_person(), others, drive_.tally().collisions);
    if (result_.found || now() >= believe_again_) {
      observer_->believed(now(), world_.mission_);
      believe_again_ = now() + kBeliefPeriod;
    }
  }

  static Bystander bystander(const simulator::Walker& walker) {
    const Pose2& pose = walker.map_from_person();
    return {walker.body(), walker.speed_mps() * Vector2d{std::cos(pose.heading), std::sin(pose.heading)}};
  }

  void finish() {
    result_.time_s = elapsed_s();
    const ExploredShares shares = world_.mission_.explored();
    result_.explored = shares.all;
    result_.explored_robot = shares.by_agent[SearchMission::kRobot];
    result_.explored_human = shares.by_agent[SearchMission::kPerson];
    result_.robot = drive_.tally();
    if (observer_ != nullptr) {
      if (!result_.found) observer_->believed(now(), world_.mission_);
      observer_->ended(now(), result_);
    }
    if (result_.found) world_.mission_.found();
    world_.mission_.end_session();
  }

  EpisodeWorld& world_;
  const std::optional<PlanningTime>& time_;
  EpisodeObserver* observer_;
  simulator::Scene scene_;
  Vector2d token_;
  Rng rng_;
  Rng human_rng_;
  Rng detection_rng_;
  Human human_;
  simulator::Walker walker_;
  simulator::Route route_;
  std::vector<simulator::PasserBy> passers_by_;
  RobotDrive drive_;
  PersonWatch watch_;
  Searcher robot_eye_;
  Searcher human_eye_;

  Time began_{};
  std::string session_;
  std::string told_plan_;
  PlanStanding told_standing_ = PlanStanding::None;
  Time tell_again_{};
  Time believe_again_{};
  std::uint64_t sequence_number_ = 0;
  bool may_move_ = false;
  std::optional<simulator::PhonePlan> phone_plan_;
  bool replan_refused_ = false;
  EpisodeResult result_;
};

EpisodeWorld::EpisodeWorld(const simulator::Scenario& scenario, const OccupancyGrid& map, const TeamOptions& options)
    : scenario_(scenario),
      options_(options),
      place_(map),
      ground_(place_.largest_ground(simulator::kRobotRoom_m)),
      person_world_(map, person_of(options.planner, "human"),
                    search_world_options(options.planner, "robot", "human", scenario.robot_start.position()).area),
      mission_(options.planner, "robot", "human"),
      now_(from_stamp_ns(1'700'000'000'000'000'000)) {
  mission_.set_map(map);
  mission_.robot_at(now_, scenario.robot_start);
  mission_.step(now_, [] { return false; });  // prepares
}

std::optional<EpisodeResult> EpisodeWorld::play(std::string_view human, std::uint64_t seed,
                                                const std::optional<PlanningTime>& planning_time,
                                                const std::function<bool()>& stop, EpisodeObserver* observer) {
  return Episode(*this, human, seed, planning_time, observer).play(stop);
}

}  // namespace tandem::experiment
