#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"
#include "services/mapping/core/map_areas.hpp"
#include "services/planner/core/acceptance/plan_acceptance.hpp"
#include "services/planner/core/inform/inform_schedule.hpp"
#include "services/planner/core/inform/person_knowledge.hpp"
#include "services/planner/core/mission/drawn_source.hpp"
#include "services/planner/core/mission/person_habits.hpp"
#include "services/planner/core/mission/replan_reason.hpp"
#include "services/planner/core/mission/watch.hpp"
#include "services/planner/core/roles/role.hpp"
#include "services/planner/core/search/belief_edit.hpp"
#include "services/planner/core/srs/reward_world.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// What a person asks for on the phone.
struct PersonRequest {
  enum class Kind { MyPose, MyGoal, RobotGoal, Replan, ClearMyGoal, ClearRobotGoal };
  Kind kind = Kind::Replan;
  Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< [m]
};

/// How far the robot is with a plan.
struct RobotProgress {
  std::string plan_id;
  bool finished = false;
  bool blocked = false;
  Eigen::Vector2d blocked_at_in_map = Eigen::Vector2d::Zero();  ///< [m]
};

/// A plan as it is told to the team.
struct MissionPlan {
  struct Member {
    std::string agent;
    TimedPath path;  ///< from `start`
    Eigen::Vector2d goal_in_map = Eigen::Vector2d::Zero();
    bool goal_fixed = false;
  };
  std::string id;
  std::uint64_t world_version = 0;
  Time start{};
  Time valid_until{};
  Role role = Role::LeaderFollower;
  std::vector<Member> members;
  Forecast forecast;
  double lower_bound_s = 0.0;  ///< no plan has a smaller expected time; 0: not known (yet)
  std::string reason;          ///< for a new plan
  std::string explanation;     ///< why this one, for people
};

/// What the person is to be told.
struct PersonInform {
  std::uint64_t number = 0;  ///< grows with each message
  std::string source_id;
  std::string reason;  ///< for them
};

/// What the planner is doing.
enum class MissionActivity { Idle, Computing, Failed, Finished };

/// A search by one robot and one person, from preparation to the find: keeps the belief, makes plans when they are
/// needed, follows their acceptance. Everything comes in by call, with its time; step() does the work.
class SearchMission {
 public:
  SearchMission(const PlannerConfig& config, std::string robot, std::string person);
  ~SearchMission();

  /// `zones`: those of the map; the robot's paths keep out of them.
  void set_map(OccupancyGrid map, std::vector<MapArea> zones = {});
  /// A session of this name runs: a new name is a new search.
  void run_session(const std::string& code, Time now);
  void end_session();
  void robot_at(Time stamp, const Pose2& map_from_robot);
  /// `age_s`: since somebody saw the person or they said where they are.
  void person_at(Time stamp, const Pose2& map_from_person, double age_s);
  /// Does what the person asks for, or says why not.
  [[nodiscard]] std::optional<std::string> request(const PersonRequest& request, Time now);
  /// Changes where the object is believed to be as the person says, or says why not.
  [[nodiscard]] std::optional<std::string> edit_belief(const BeliefEdit& edit);
  /// Adds or removes what the person draws on the map, or says why not. A plan that enters what it is now kept out of
  /// is withdrawn at once.
  [[nodiscard]] std::optional<std::string> edit_source(const SourceEdit& edit, Time now);
  void robot_progress(const RobotProgress& progress, Time now);
  /// The object is found: the search is over.
  void found();

  /// Computes for one slice, which ends when `slice_over` says so. Returns true when there is a new plan.
  bool step(Time now, const std::function<bool()>& slice_over);
  /// Finds the lower bound of the plan that the last step() or conclude() gave; false if there was none. It is not part
  /// of these, so that a plan is out first; asked for before anything else is done.
  bool certify();
  /// Ends computing with the best plan so far; false if no plan is being computed.
  bool conclude(Time now);

  /// The newest message to the person; none yet in this search.
  [[nodiscard]] const std::optional<PersonInform>& inform() const { return inform_; }
  /// They have taken notice of the message of this number.
  void inform_heard(std::uint64_t number);

  [[nodiscard]] MissionActivity activity() const { return activity_; }
  [[nodiscard]] double progress() const;  ///< of computing, [0, 1]
  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] const std::optional<MissionPlan>& plan() const { return plan_; }
  [[nodiscard]] PlanStanding standing(Time now) const { return acceptance_.standing(now); }
  /// The goal a person fixed for the robot (kRobot) or themselves (kPerson).
  [[nodiscard]] const std::optional<Eigen::Vector2d>& goal(std::size_t member) const { return goals_[member]; }
  [[nodiscard]] const std::string& agent(std::size_t member) const { return agents_[member]; }
  /// The goals, and what has been drawn.
  [[nodiscard]] std::vector<RewardSource> sources() const;
  /// A drawn place to go to is one thing with the goal it makes; one to pass through pays only before the goal of
  /// whoever is to pass.
  [[nodiscard]] std::vector<Relation> relations() const;
  /// None before map and robot are known.
  [[nodiscard]] const SearchArea* area() const { return world_ ? &world_->area() : nullptr; }
  [[nodiscard]] const SearchBelief* belief() const { return belief_ ? &*belief_ : nullptr; }
  [[nodiscard]] ExploredShares explored() const;

  static constexpr std::size_t kRobot = 0;
  static constexpr std::size_t kPerson = 1;

 private:
  struct Seen {
    Time stamp{};
    Pose2 map_from_agent;
    double age_s = 0.0;
  };
  struct Computation;

  void prepare();
  void start_search();
  void fail(const std::string& why);
  [[nodiscard]] bool person_is_known(Time now) const;
  [[nodiscard]] PlanSituation situation(Time now) const;
  void begin_plan(Time now, const std::string& reason);
  void finish_plan(Time now);
  void begin_computing_anew();
  void stop_computing();
  void forget_old_blockages(Time now);
  [[nodiscard]] std::vector<BlockedDisc> kept_out_of(std::size_t member) const;
  void find_ways_anew(std::size_t member, const std::vector<BlockedDisc>& blocked);
  void find_ways_around_blockages();
  void renew_ways(const SourceEdit& edit);
  [[nodiscard]] bool gets_somewhere(std::size_t member);
  [[nodiscard]] std::optional<std::string> keep_out(const SourceEdit& edit);
  [[nodiscard]] std::optional<std::string> go_to(const SourceEdit& edit, Time now);
  [[nodiscard]] std::optional<std::string> pass_through(const SourceEdit& edit);
  [[nodiscard]] std::optional<Eigen::Vector2d> floor_in(const PlanarShape& region) const;
  [[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> way_between(std::size_t member, const Eigen::Vector2d& from,
                                                                        const Eigen::Vector2d& to) const;
  void lead_through(SearchMember& who) const;
  [[nodiscard]] std::optional<std::string> stay_behind(const SourceEdit& edit);
  [[nodiscard]] bool keeps_robot_behind(Time now) const;
  [[nodiscard]] double robot_ahead_m() const;
  [[nodiscard]] bool close_what_is_ahead(Time now);
  void open_what_is_ahead();
  [[nodiscard]] bool lead_behind(SearchMember& robot) const;
  void drop_passed_places();
  [[nodiscard]] std::optional<std::string> remove_source(const std::string& id);
  [[nodiscard]] bool concerns(const SourceEdit& edit, std::size_t member) const;
  void forget_drawn_goals(std::size_t member);
  void forget_drawn();
  [[nodiscard]] bool plan_enters(const SourceEdit& edit, Time now) const;
  [[nodiscard]] SearchMember member_of_plan(std::size_t member, Time now) const;
  [[nodiscard]] std::vector<TimedPath> rest_of_plan(Time now) const;
  void propose(MissionPlan plan, double duration_s, Time now);
  [[nodiscard]] std::string explanation(const JointPlan& joint, const MissionPlan& plan) const;
  void follow_person(Time now);
  void begin_knowledge();
  void consider_informing(Time now);
  [[nodiscard]] InformOption belief_option(Time now, double own_way);
  [[nodiscard]] std::optional<InformOption> source_option(const SourceEdit& drawn, double own_way) const;
  void drop_reached_goals(Time now);
  [[nodiscard]] double elapsed_s(Time now) const;

  PlannerConfig config_;
  std::array<std::string, 2> agents_;
  std::optional<OccupancyGrid> map_;
  std::vector<MapArea> zones_;
  std::unique_ptr<SearchWorld> world_;
  std::optional<SearchBelief> belief_;
  std::array<Watch, 2> watches_;
  std::array<std::optional<Seen>, 2> seen_;
  std::array<std::optional<Eigen::Vector2d>, 2> goals_;

  std::string session_;
  bool running_ = false;
  Time running_since_{};
  MissionActivity activity_ = MissionActivity::Idle;
  std::string failure_;
  Time failed_{};

  std::unique_ptr<Computation> computation_;
  std::unique_ptr<Computation> certifiable_;  ///< whose plan has just come out
  std::optional<MissionPlan> plan_;
  PlanAcceptance acceptance_;
  Time proposed_{};                 ///< when what the team reads now was first shown to them
  bool postponed_ = false;          ///< edits have put off the acceptance once already
  double left_when_planned_ = 1.0;  ///< P(not found) when the plan was made
  std::vector<double> survival_;    ///< what the plan promises
  bool begun_anew_ = false;         ///< edits have cut short the making of this plan once already
  bool person_planned_ = false;
  bool person_said_where_ = false;
  bool person_drew_ = false;
  bool person_reached_goal_ = false;
  std::optional<Time> person_off_plan_since_;
  std::optional<Time> blocked_since_;
  Eigen::Vector2d blocked_at_ = Eigen::Vector2d::Zero();
  bool robot_finished_ = false;
  PersonHabits habits_;
  std::optional<PersonKnowledge> knowledge_;  ///< of the person, as soon as there is a belief
  InformSchedule informs_;
  std::optional<PersonInform> inform_;
  std::uint64_t inform_number_ = 0;
  Time inform_due_{};
  std::vector<SourceEdit> drawn_;
  std::vector<std::pair<Time, BlockedDisc>> blocked_;
  std::optional<BlockedDisc> ahead_;  ///< of the person, whom the robot is to stay behind, when the plan was made
  std::vector<std::vector<TimedPath>> rejected_;
  std::uint64_t world_version_ = 0;
  std::uint64_t plans_ = 0;
};

}  // namespace tandem
