#include "tests/browser/fake_messages.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tandem::test {
namespace {

msg::PlannedPath planned_path(const char* agent, const std::vector<msg::Point2>& points, bool fixed, Time now) {
  msg::PlannedPath path;
  path.agent(agent);
  double time_s = 0.0;
  for (const auto& at : points) {
    msg::TimedPoint timed;
    timed.stamp_ns(to_stamp_ns(now + from_seconds(time_s)));
    timed.x_m(at.x());
    timed.y_m(at.y());
    path.points().push_back(timed);
    time_s += 10.0;
  }
  path.goal_in_map(points.back());
  path.goal_fixed(fixed);
  return path;
}

msg::CollaborationRole role_of(const FakeGoals& goals) {
  if (goals.person) return goals.robot ? msg::ROLE_MASTER_SLAVE : msg::ROLE_PEER_PEER;
  return goals.robot ? msg::ROLE_LEADER_LEADER : msg::ROLE_LEADER_FOLLOWER;
}

}  // namespace

msg::Point2 point(double x, double y) {
  msg::Point2 at;
  at.x(x);
  at.y(y);
  return at;
}

msg::OccupancyGrid fake_room() {
  msg::OccupancyGrid grid;
  grid.map_id("fake room");
  grid.resolution_m(0.1);
  grid.width(240);
  grid.height(160);
  std::vector<std::uint8_t> cells(240 * 160, 0);
  for (int row = 0; row < 160; ++row) {
    for (int column = 0; column < 240; ++column) {
      const bool wall = row < 3 || row >= 157 || column < 3 || column >= 237 || (row > 95 && row < 99 && column < 150);
      const bool pillar = row % 40 > 17 && row % 40 < 24 && column % 40 > 17 && column % 40 < 24 && row < 90;
      if (wall || pillar) cells[static_cast<std::size_t>(row * 240 + column)] = 100;
    }
  }
  grid.cells(cells);
  return grid;
}

msg::TeamPlan fake_plan(int number, const msg::Point2& person, const FakeGoals& goals, Time now) {
  msg::TeamPlan plan;
  plan.robot("robot1");
  plan.id("plan-" + std::to_string(number));
  plan.planner("fake");
  plan.stamp_ns(to_stamp_ns(now));
  plan.valid_until_ns(to_stamp_ns(now + from_seconds(600.0)));
  plan.state(msg::PLAN_ACCEPTED);
  plan.role(role_of(goals));
  plan.probability_found(0.6);
  plan.reason("both sides of the columns");
  plan.paths(
      {planned_path("robot1", {point(2, 2), point(2, 4.2), point(13, 4.2), goals.robot.value_or(point(18, 7))},
                    goals.robot.has_value(), now),
       planned_path("person1", {person, point(person.x(), 8.5), point(20, 8.5), goals.person.value_or(point(20, 13))},
                    goals.person.has_value(), now)});
  return plan;
}

msg::SearchBelief fake_belief(double travelled_m, std::int64_t stamp_ns) {
  msg::SearchBelief belief;
  belief.robot("robot1");
  belief.stamp_ns(stamp_ns);
  belief.resolution_m(0.5);
  belief.width(48);
  belief.height(32);
  belief.origin_in_map(point(0, 0));
  std::vector<std::uint8_t> cells;
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 48; ++column) {
      const double away = std::hypot(0.5 * column - 17.0, 0.5 * row - 7.0);
      const bool seen = column < 10 + static_cast<int>(travelled_m) && row < 18;
      cells.push_back(seen ? 0 : static_cast<std::uint8_t>(254.0 * std::exp(-away / 8.0)));
    }
  }
  belief.cells(cells);
  belief.explored(std::min(1.0, 0.1 + travelled_m / 40.0));
  return belief;
}

msg::TeammateState fake_teammate(const msg::Point2& at, bool lost, std::int64_t stamp_ns) {
  msg::TeammateState person;
  person.agent("person1");
  person.robot("robot1");
  person.stamp_ns(stamp_ns);
  msg::Pose pose;
  pose.x(at.x());
  pose.y(at.y());
  person.map_from_agent(pose);
  person.source(lost ? msg::SOURCE_PREDICTED : msg::SOURCE_MESSAGE);
  person.state(lost ? msg::TRACK_LOST : msg::TRACK_TRACKED);
  return person;
}

msg::BaseStatus fake_base_status(bool stopped, std::int64_t stamp_ns) {
  msg::BaseStatus base;
  base.robot("robot1");
  base.stamp_ns(stamp_ns);
  base.connected(true);
  base.motors_enabled(true);
  base.battery_v(12.6);
  base.latched(stopped);
  if (stopped) base.stop_reasons({msg::STOP_REQUESTED});
  return base;
}

msg::PlanExecution fake_execution(bool moving, std::int64_t stamp_ns) {
  msg::PlanExecution execution;
  execution.robot("robot1");
  execution.stamp_ns(stamp_ns);
  execution.moving(moving);
  return execution;
}

msg::LinkStatus fake_link_status() {
  msg::LinkStatus link;
  link.host("laptop1");
  link.peer("robot1");
  link.up(true);
  link.round_trip_s(0.004);
  return link;
}

msg::RewardSource fake_source(const msg::SourceEdit& edit) {
  msg::RewardSource source;
  source.id(edit.source_id());
  source.boundary_in_map(edit.boundary_in_map());
  source.radius_m(edit.boundary_in_map().size() == 1 ? 1.0 : 0.0);
  source.targets(edit.targets());
  return source;
}

}  // namespace tandem::test
