#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/occupancy_grid.hpp"
#include "services/planner/core/roles/role.hpp"

/// What a report is made of: one episode as its recording tells it. All times are seconds since the search began
/// (`session` running), negative before; places are in the map frame [m].
namespace tandem::experiment {

/// Where somebody is.
struct PoseAt {
  double time_s = 0.0;
  Pose2 map_from_agent = {};
};

/// A press on the phone.
struct PressAt {
  double time_s = 0.0;
  std::string kind = {};  ///< "my_pose", "my_goal", "robot_goal", "replan", "clear_my_goal", "clear_robot_goal"
  std::optional<Eigen::Vector2d> point_in_map = {};
};

/// A plan, or what became of it: each change is an entry.
struct PlanAt {
  enum class State { Proposed, Accepted, Rejected, Superseded };
  struct Path {
    std::string agent = {};
    std::vector<double> times_s = {};
    std::vector<Eigen::Vector2d> points_in_map = {};  ///< one per time
  };
  double time_s = 0.0;
  std::string id = {};
  State state = State::Proposed;
  Role role = Role::LeaderFollower;
  double expected_time_s = 0.0;
  double lower_bound_s = 0.0;  ///< 0: not known
  std::vector<Path> paths = {};
};

/// The team's belief, and how much of the searched area has been seen, by whom first.
struct BeliefAt {
  double time_s = 0.0;
  double explored = 0.0;        ///< [0, 1]
  double explored_robot = 0.0;  ///< [0, 1]
  double explored_human = 0.0;  ///< [0, 1]
  double probability_left = 0.0;
  int width = 0;
  int height = 0;
  double resolution_m = 0.0;
  Eigen::Vector2d origin_in_map = Eigen::Vector2d::Zero();  ///< corner of cell (0, 0)
  double peak = 0.0;                                        ///< probability of a cell of 254
  std::vector<std::uint8_t> cells = {};  ///< row by row; 0..254: share of the peak, 255: not searched
};

/// What the base says of itself.
struct BaseAt {
  double time_s = 0.0;
  double speed_limit_mps = 0.0;
  bool latched = false;
  std::vector<std::string> stop_reasons = {};  ///< most urgent first; empty while free to move
};

/// The link as one host sees it.
struct LinkAt {
  double time_s = 0.0;
  bool up = false;
  double round_trip_s = 0.0;
  double loss = 0.0;  ///< [0, 1]
};

/// A reminder on the phone, or that it was obeyed.
struct ReminderAt {
  double time_s = 0.0;
  std::string kind = {};
  bool obeyed = false;  ///< else: it fired
};

/// Somebody who is not of the team.
struct PassersByAt {
  double time_s = 0.0;
  std::vector<Eigen::Vector2d> points_in_map = {};
};

struct EpisodeLog {
  std::string name = {};  ///< of the recording, for people
  std::string code = {};  ///< of the session
  std::int64_t started_ns = 0;
  std::string robot = {};
  std::string agent = {};                          ///< the person
  std::map<std::string, std::string> fields = {};  ///< condition, reminder, mode, and each answer of a form
  std::string outcome = {};   ///< "found", "time_limit", "aborted"; empty: the recording ends before
  double duration_s = 0.0;    ///< until the session ended, or the recording
  std::string found_by = {};  ///< agent; empty: nobody
  std::optional<Eigen::Vector2d> object_in_map = {};

  std::optional<OccupancyGrid> map = {};
  std::vector<PressAt> presses = {};  ///< every list ascending in time
  std::vector<PlanAt> plans = {};
  std::vector<BeliefAt> beliefs = {};
  std::vector<PoseAt> robot_poses = {};  ///< as localized
  std::vector<PoseAt> human_poses = {};  ///< true where that is recorded, else as tracked
  bool human_is_true = false;
  std::vector<PassersByAt> passers_by = {};
  std::vector<BaseAt> base = {};
  std::vector<LinkAt> link = {};
  std::vector<ReminderAt> reminders = {};
  std::uint32_t collisions = 0;  ///< of the simulated robot

  [[nodiscard]] bool found() const { return outcome == "found"; }
};

/// Whether two recordings tell of one search: those of robot and laptop do.
[[nodiscard]] bool is_same_search(const EpisodeLog& a, const EpisodeLog& b);

/// One log of two recordings of one search: of each list the one that holds more.
[[nodiscard]] EpisodeLog merged(EpisodeLog a, EpisodeLog b);

/// What a log lacks, in words for people.
[[nodiscard]] std::vector<std::string> gaps_of(const EpisodeLog& episode);

}  // namespace tandem::experiment
