#include "services/planner/planner_messages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

msg::Point2 to_message(const Eigen::Vector2d& point_in_map) {
  msg::Point2 message;
  message.x(point_in_map.x());
  message.y(point_in_map.y());
  return message;
}

msg::PlanState to_message(PlanStanding standing) {
  switch (standing) {
    case PlanStanding::Proposed:
      return msg::PLAN_PROPOSED;
    case PlanStanding::Accepted:
      return msg::PLAN_ACCEPTED;
    case PlanStanding::Rejected:
      return msg::PLAN_REJECTED;
    case PlanStanding::None:
    case PlanStanding::Superseded:
    case PlanStanding::Expired:
      break;
  }
  return msg::PLAN_SUPERSEDED;
}

msg::CollaborationRole to_message(Role role) {
  switch (role) {
    case Role::LeaderFollower:
      return msg::ROLE_LEADER_FOLLOWER;
    case Role::PeerPeer:
      return msg::ROLE_PEER_PEER;
    case Role::MasterSlave:
      return msg::ROLE_MASTER_SLAVE;
    case Role::LeaderLeader:
      break;
  }
  return msg::ROLE_LEADER_LEADER;
}

msg::PlannerActivity to_message(MissionActivity activity) {
  switch (activity) {
    case MissionActivity::Idle:
      return msg::PLANNER_IDLE;
    case MissionActivity::Computing:
      return msg::PLANNER_COMPUTING;
    case MissionActivity::Failed:
      return msg::PLANNER_FAILED;
    case MissionActivity::Finished:
      break;
  }
  return msg::PLANNER_FINISHED;
}

std::string to_message(RelationKind kind) {
  switch (kind) {
    case RelationKind::Strict:
      return "strict";
    case RelationKind::Soft:
      return "soft";
    case RelationKind::Codependent:
      break;
  }
  return "codependent";
}

std::string to_message(SourceKind kind) {
  switch (kind) {
    case SourceKind::Environment:
      return "environment";
    case SourceKind::Action:
      return "action";
    case SourceKind::Task:
      return "task";
    case SourceKind::Interaction:
      break;
  }
  return "interaction";
}

}  // namespace

std::optional<OccupancyGrid> to_core(const msg::OccupancyGrid& message) {
  const auto map_from_grid = to_core(message.map_from_grid());
  const std::size_t cells = static_cast<std::size_t>(message.width()) * message.height();
  if (!map_from_grid || cells == 0 || cells != message.cells().size() || !(message.resolution_m() > 0.0) ||
      !std::isfinite(message.resolution_m()) || message.width() > 100'000 || message.height() > 100'000) {
    return std::nullopt;
  }
  OccupancyGrid grid(static_cast<int>(message.width()), static_cast<int>(message.height()), message.resolution_m(),
                     *map_from_grid);
  std::ranges::transform(message.cells(), grid.cells().begin(), [](std::uint8_t cell) {
    if (cell == static_cast<std::uint8_t>(CellState::Free)) return CellState::Free;
    return cell == static_cast<std::uint8_t>(CellState::Occupied) ? CellState::Occupied : CellState::Unknown;
  });
  return grid;
}

std::optional<Pose2> to_core(const msg::Pose& message) {
  if (!std::isfinite(message.x()) || !std::isfinite(message.y()) || !std::isfinite(message.heading())) {
    return std::nullopt;
  }
  return Pose2{message.x(), message.y(), wrap_to_pi(message.heading())};
}

std::optional<PersonRequest> to_core(const msg::HumanMessage& message) {
  PersonRequest request;
  request.point_in_map = {message.point_in_map().x(), message.point_in_map().y()};
  if (!request.point_in_map.allFinite()) return std::nullopt;
  switch (message.kind()) {
    case msg::HUMAN_MY_POSE:
      request.kind = PersonRequest::Kind::MyPose;
      return request;
    case msg::HUMAN_MY_GOAL:
      request.kind = PersonRequest::Kind::MyGoal;
      return request;
    case msg::HUMAN_ROBOT_GOAL:
      request.kind = PersonRequest::Kind::RobotGoal;
      return request;
    case msg::HUMAN_REPLAN:
      request.kind = PersonRequest::Kind::Replan;
      return request;
    case msg::HUMAN_CLEAR_MY_GOAL:
      request.kind = PersonRequest::Kind::ClearMyGoal;
      return request;
    case msg::HUMAN_CLEAR_ROBOT_GOAL:
      request.kind = PersonRequest::Kind::ClearRobotGoal;
      return request;
  }
  return std::nullopt;  // a kind of a later version
}

RobotProgress to_core(const msg::PlanExecution& message) {
  RobotProgress progress;
  progress.plan_id = message.plan_id();
  progress.finished = message.finished();
  progress.blocked_at_in_map = {message.blocked_at_in_map().x(), message.blocked_at_in_map().y()};
  progress.blocked = message.blocked() && progress.blocked_at_in_map.allFinite();
  return progress;
}

msg::TeamPlan to_message(const MissionPlan& plan, PlanStanding standing, const PlanEnvelope& envelope) {
  msg::TeamPlan message;
  message.robot(envelope.robot);
  message.id(plan.id);
  message.session(envelope.session);
  message.planner(envelope.planner);
  message.sequence_number(envelope.sequence_number);
  message.world_version(plan.world_version);
  message.stamp_ns(to_stamp_ns(envelope.now));
  message.valid_until_ns(to_stamp_ns(plan.valid_until));
  message.state(to_message(standing));
  message.role(to_message(plan.role));
  message.value(plan.forecast.expected_time_s);
  message.probability_found(plan.forecast.probability_found);
  message.lower_bound_s(plan.lower_bound_s);
  message.reason(plan.explanation);
  for (const auto& member : plan.members) {
    msg::PlannedPath path;
    path.agent(member.agent);
    for (const auto& point : member.path.points) {
      msg::TimedPoint timed;
      timed.stamp_ns(to_stamp_ns(plan.start + from_seconds(point.time_s)));
      timed.x_m(point.point_in_map.x());
      timed.y_m(point.point_in_map.y());
      path.points().push_back(timed);
    }
    path.goal_in_map(to_message(member.goal_in_map));
    path.goal_fixed(member.goal_fixed);
    message.paths().push_back(std::move(path));
  }
  return message;
}

msg::SearchBelief belief_message(const SearchMission& mission, const std::string& robot, Time now) {
  constexpr std::uint8_t kNotSearched = 255;
  constexpr double kSteps = 254.0;
  const SearchArea& area = *mission.area();
  const auto posterior = mission.belief()->posterior();
  const double peak = posterior.empty() ? 0.0 : *std::max_element(posterior.begin(), posterior.end());
  msg::SearchBelief message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(now));
  message.resolution_m(area.cell_size_m());
  message.width(static_cast<std::uint32_t>(area.width()));
  message.height(static_cast<std::uint32_t>(area.height()));
  message.origin_in_map(to_message(area.origin_in_map()));
  message.peak(peak);
  for (int row = 0; row < area.height(); ++row) {
    for (int column = 0; column < area.width(); ++column) {
      const int cell = area.cell_of(column, row);
      const double share = cell >= 0 && peak > 0.0 ? posterior[static_cast<std::size_t>(cell)] / peak : 0.0;
      message.cells().push_back(cell < 0 ? kNotSearched : static_cast<std::uint8_t>(std::lround(kSteps * share)));
    }
  }
  const ExploredShares explored = mission.explored();
  message.explored(explored.all);
  for (const std::size_t member : {SearchMission::kRobot, SearchMission::kPerson}) {
    msg::ExploredShare share;
    share.agent(mission.agent(member));
    share.share(explored.by_agent[member]);
    message.explored_by().push_back(share);
  }
  message.probability_left(mission.belief()->probability_left());
  return message;
}

msg::PlannerStatus status_message(const SearchMission& mission, const std::string& robot, double computing_s,
                                  Time now) {
  msg::PlannerStatus message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(now));
  message.activity(to_message(mission.activity()));
  message.progress(mission.activity() == MissionActivity::Computing ? mission.progress() : 1.0);
  message.computing_s(computing_s);
  message.reason(mission.failure());
  return message;
}

msg::RewardSource to_message(const RewardSource& source) {
  msg::RewardSource message;
  message.id(source.id);
  message.kind(to_message(source.kind));
  message.meaning(source.meaning);
  // The contract knows discs and polygons that lie still; of anything else it carries everything but the place.
  const auto shape = shape_in_map(source.boundary);
  if (const auto* disc = shape ? std::get_if<Disc>(&*shape) : nullptr) {
    message.boundary_in_map().push_back(to_message(disc->centre));
    message.radius_m(disc->radius_m);
  } else if (const auto* polygon = shape ? std::get_if<Polygon>(&*shape) : nullptr) {
    for (const auto& corner : polygon->corners) message.boundary_in_map().push_back(to_message(corner));
  }
  message.rate_per_s(peak_of(source.inside));
  message.pool(std::isfinite(source.pool) ? source.pool : -1.0);
  message.targets(source.targets);
  return message;
}

msg::SourceRelation to_message(const Relation& relation) {
  msg::SourceRelation message;
  message.from_id(relation.from);
  message.to_id(relation.to);
  message.kind(to_message(relation.kind));
  message.coupling(relation.coupling);
  return message;
}

}  // namespace tandem
