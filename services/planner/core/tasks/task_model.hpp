#pragma once

#include <bitset>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "services/planner/core/srs/mental_model.hpp"
#include "services/planner/core/tasks/task_state.hpp"
#include "services/planner/core/tasks/travel.hpp"

namespace tandem {

/// Is told what happens in a course of events, to draw it.
class TaskObserver {
 public:
  virtual ~TaskObserver() = default;
  /// Time has passed: `state` holds now.
  virtual void on_step(const TaskState& state) = 0;
  /// An agent's action is over.
  virtual void on_end(const TaskState& state, std::size_t agent) = 0;
};

/// The decisions of a team in a world of sources, and what follows from them, exactly.
///
/// A joint plan is a chain of decisions of single agents: whenever an action ends, whoever is free decides, lowest
/// number first, and time goes on when nobody is free (digest F5-F9). Everything between two decisions goes through
/// RewardAccount, so the value of a finished chain is exact. Same problem, same decisions: same values, bit for bit.
class TaskModel {
 public:
  /// `problem` must have no problem_of() and outlive the model.
  explicit TaskModel(const TaskProblem& problem);

  [[nodiscard]] const TaskProblem& problem() const { return problem_; }
  [[nodiscard]] const ResolvedWorld& world() const { return world_; }
  [[nodiscard]] std::size_t agent_count() const { return problem_.agents.size(); }
  [[nodiscard]] std::int64_t horizon_ms() const { return horizon_ms_; }
  /// When the agent must have stopped [ms].
  [[nodiscard]] std::int64_t limit_ms(std::size_t agent) const { return limits_ms_[agent]; }
  /// The message sets there are to choose from; the first is empty.
  [[nodiscard]] const std::vector<std::vector<Inform>>& messages() const { return messages_; }

  /// The state in which the first decision is due.
  [[nodiscard]] TaskState start();
  /// Whose decision is due: an agent's number, kTeller, or kNobody if the course is over.
  [[nodiscard]] int decider(const TaskState& state) const;
  static constexpr int kNobody = -1;
  static constexpr int kTeller = -2;
  /// What the decider can do, in a fixed order; never empty unless the course is over.
  void actions(const TaskState& state, std::vector<TaskAction>& out);
  /// The state in which the next decision is due after this one.
  [[nodiscard]] TaskState after(const TaskState& state, const TaskAction& action);

  /// No course that goes on from the state has its last action end sooner [ms].
  [[nodiscard]] std::int64_t least_makespan_ms(const TaskState& state) const;

  /// Whether the source may still pay the agent some time; relations that others may yet open are no obstacle.
  [[nodiscard]] bool is_hopeful(const TaskState& state, std::size_t source, std::size_t agent) const;
  /// Whether the agent knows the source, told or not (digest D2).
  [[nodiscard]] bool is_known(const TaskState& state, std::size_t source, std::size_t agent) const;
  /// What is left in the source's pool, magnitude.
  [[nodiscard]] double left(const TaskState& state, std::size_t source) const {
    return state.rewards.left[world_.sources()[source].pool];
  }
  /// When the agent would arrive at the action's place, from the state [ms].
  [[nodiscard]] std::int64_t arrival_ms(const TaskState& state, const TaskAction& action);
  /// What the hazards on the action's way cost the agent.
  [[nodiscard]] double hazard_cost(const TaskState& state, const TaskAction& action);
  /// What the agent draws in a second at a station of the source, with a full pool and all relations open [1/s], in
  /// units of the pool; 0 at other places.
  [[nodiscard]] double draw_per_s(std::size_t agent, std::size_t source, int place) const;
  /// What a second of walking costs the agent [1/s], >= 0.
  [[nodiscard]] double cost_of_walking_per_s(std::size_t agent) const { return cost_of_walking_per_s_[agent]; }
  [[nodiscard]] const Eigen::Vector2d& place(std::size_t agent, int place) const {
    return travels_[agent].point(place);
  }

  /// Tells `observer` of everything that happens from now on; nullptr: nobody.
  void observe(TaskObserver* observer) { observer_ = observer; }
  /// Writes events and payments into `record` from now on; nullptr: does not.
  void record_to(RewardRecord* record);

 private:
  struct Station {
    int place = -1;
    double draw_per_s = 0.0;
  };

  void find_stations();
  void find_messages();
  [[nodiscard]] const TaskLeg* leg(std::size_t agent, int from, int to, int way, double heading_rad);
  [[nodiscard]] const TaskLeg* kept(TaskLeg leg);
  [[nodiscard]] int place_of(std::size_t agent, const TaskAgentState& state);
  void add_visits(const TaskState& state, std::size_t agent, std::vector<TaskAction>& out);
  void add_stays(const TaskState& state, TaskAction action, std::int64_t latest_ms, std::vector<TaskAction>& out);
  void add_accompanying(const TaskState& state, std::size_t agent, std::vector<TaskAction>& out) const;
  [[nodiscard]] bool leads_to_goal(const TaskState& state, std::size_t agent);
  [[nodiscard]] bool may_hold(const TaskState& state, std::size_t agent) const;
  [[nodiscard]] std::int64_t latest_leave_ms(std::size_t agent, int from_place, std::size_t next, double next_left);
  [[nodiscard]] std::int64_t way_to_goal_ms(std::size_t agent, int from_place);
  [[nodiscard]] double drawn_per_s_at(std::size_t agent, std::size_t source, const Eigen::Vector2d& point_in_map) const;
  [[nodiscard]] std::optional<int> nearest_station(std::size_t agent, std::size_t source, int from_place);
  void find_next_sources(const TaskState& state, std::size_t agent, std::size_t source, int place);

  void begin(TaskState& state, const TaskAction& action);
  void run(TaskState& state);
  void step(TaskState& state);
  [[nodiscard]] std::int64_t next_change_ms(const TaskState& state, std::size_t agent) const;
  [[nodiscard]] AgentMove move_of(const TaskState& state, std::size_t agent, std::int64_t until_ms) const;
  [[nodiscard]] AgentMove move_with(const TaskState& state, std::size_t agent, std::int64_t until_ms);
  void advance(TaskState& state, std::int64_t until_ms);
  void end_actions(TaskState& state);
  [[nodiscard]] bool is_over(const TaskState& state, std::size_t agent) const;

  const TaskProblem& problem_;
  ResolvedWorld world_;
  std::int64_t horizon_ms_ = 0;
  std::vector<std::int64_t> limits_ms_;
  std::vector<std::bitset<kMaxTaskSources>> known_;  ///< by agent, before any message
  std::vector<std::vector<Inform>> messages_;
  std::vector<std::vector<std::bitset<kMaxTaskSources>>> told_;  ///< by message set and agent
  std::vector<double> cost_of_walking_per_s_;
  std::deque<MotionMap> motion_maps_;
  std::deque<Hazards> hazards_;
  std::vector<Travel> travels_;                              ///< by agent
  std::vector<std::vector<std::vector<Station>>> stations_;  ///< by agent and source, the middle first
  std::vector<std::optional<int>> goal_places_;              ///< by agent
  std::vector<std::map<std::pair<int, std::size_t>, std::optional<int>>> nearest_stations_;  ///< by agent
  bool has_soft_relations_ = false;
  bool has_moving_sources_ = false;
  std::vector<std::vector<std::size_t>> gates_of_pool_;  ///< that wait for the pool
  std::deque<TaskLeg> legs_;
  std::map<std::tuple<std::size_t, int, int, int, double>, const TaskLeg*> leg_of_;
  RewardAccount account_;
  RewardRecord events_;
  RewardRecord* record_ = nullptr;
  TaskObserver* observer_ = nullptr;
  std::vector<AgentMove> moves_;
  std::vector<double> rewards_;
  std::vector<std::pair<double, std::size_t>> next_sources_;  ///< by distance
};

}  // namespace tandem
