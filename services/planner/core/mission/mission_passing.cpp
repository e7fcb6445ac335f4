// The part of SearchMission that leads members as a person drew: through places, and the robot behind them.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "services/planner/core/mission/computation.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kStartReach_m = 3.0;
constexpr double kPlaceReach_m = 0.5;
constexpr double kFar_m = 1e5;     ///< a disc of this radius is a half-plane on any map
constexpr double kBehind_m = 1.5;  ///< where the robot goes that was ahead

Vector2d direction_of(const Pose2& pose) {
  return {std::cos(pose.heading), std::sin(pose.heading)};
}

/// `path`, then `way` at the pace of `searcher`.
void append_way(TimedPath& path, const std::vector<Vector2d>& way, const Searcher& searcher, double heading_rad) {
  const double begin_s = path.duration_s();
  for (const TimedPoint& point : timed_path(way, searcher, heading_rad).points) {
    if (path.points.empty() || point.time_s > 0.0) path.points.push_back({begin_s + point.time_s, point.point_in_map});
  }
}

}  // namespace

/// A point of the searched floor in the region, the nearest to its middle.
std::optional<Vector2d> SearchMission::floor_in(const PlanarShape& region) const {
  const Vector2d middle = inner_point(region);
  if (world_->area().cell_at(middle)) return middle;
  std::optional<Vector2d> nearest;
  for (int cell = 0; cell < world_->area().size(); ++cell) {
    const Vector2d& point = world_->area().point(cell);
    if (!contains(region, point)) continue;
    if (!nearest || (point - middle).norm() < (*nearest - middle).norm()) nearest = point;
  }
  return nearest;
}

/// How `member` gets from one place to another; none if it does not.
std::optional<std::vector<Vector2d>> SearchMission::way_between(std::size_t member, const Vector2d& from,
                                                                const Vector2d& to) const {
  ActionSet& actions = world_->actions(static_cast<int>(member));
  const auto start = actions.add_place(from, kStartReach_m);
  const auto end = actions.add_place(to, kPlaceReach_m);
  if (!start || !end) return std::nullopt;
  const Leg& leg = actions.leg(*start, *end);
  if (!leg.possible()) return std::nullopt;
  std::vector<Vector2d> way = leg.way;
  way.front() = from;
  return way;
}

std::optional<std::string> SearchMission::pass_through(const SourceEdit& edit) {
  const std::size_t member = edit.targets.front() == agents_[kRobot] ? kRobot : kPerson;
  const auto place = floor_in(edit.region);
  if (!place) return "there is no floor to pass over there";
  if (seen_[member]) {
    const Vector2d here = seen_[member]->map_from_agent.position();
    if (contains(edit.region, here)) return agents_[member] + " stands there";
    if (!way_between(member, here, *place)) return "no way leads " + agents_[member] + " through there";
  }
  drawn_.push_back(edit);
  return std::nullopt;
}

/// Leads one who is planned for straight through the places drawn for it, in the order in which they were drawn: what
/// it does then, up to its fixed goal or not, is planned.
void SearchMission::lead_through(SearchMember& who) const {
  const auto member = static_cast<std::size_t>(who.searcher);
  for (const SourceEdit& drawn : drawn_) {
    if (drawn.kind != SourceEdit::Kind::PassThrough || !concerns(drawn, member)) continue;
    const auto& walked = who.committed.points;
    const Vector2d from = walked.empty() ? who.pose.position() : walked.back().point_in_map;
    const double heading_rad =
        walked.size() < 2 ? who.pose.heading
                          : heading_towards(walked[walked.size() - 2].point_in_map, walked.back().point_in_map);
    const auto place = floor_in(drawn.region);
    const auto way = place ? way_between(member, from, *place) : std::nullopt;
    if (way) append_way(who.committed, *way, world_->searcher(who.searcher), heading_rad);
  }
}

/// A place to pass through has paid as soon as whoever is to pass is in it.
void SearchMission::drop_passed_places() {
  const auto is_passed = [&](const SourceEdit& drawn) {
    if (drawn.kind != SourceEdit::Kind::PassThrough) return false;
    const auto& seen = seen_[drawn.targets.front() == agents_[kRobot] ? kRobot : kPerson];
    return seen && contains(drawn.region, seen->map_from_agent.position());
  };
  if (std::erase_if(drawn_, is_passed) > 0) ++world_version_;
}

std::optional<std::string> SearchMission::stay_behind(const SourceEdit& edit) {
  if (edit.who != agents_[kPerson]) return "only the robot can be kept behind somebody";
  if (!seen_[kPerson]) return "nobody knows where " + edit.who + " is";
  if (std::ranges::find(drawn_, SourceEdit::Kind::StayBehind, &SourceEdit::kind) != drawn_.end()) {
    return "the robot stays behind already";
  }
  const Pose2& person = seen_[kPerson]->map_from_agent;
  SourceEdit drawn = edit;
  drawn.targets = {agents_[kRobot]};
  drawn.region = HalfPlane{person.position(), -direction_of(person)};  // as it lies now
  drawn_.push_back(drawn);
  return std::nullopt;
}

bool SearchMission::keeps_robot_behind(Time now) const {
  return person_is_known(now) &&
         std::ranges::find(drawn_, SourceEdit::Kind::StayBehind, &SourceEdit::kind) != drawn_.end();
}

/// How far the robot is ahead of the person, whichever way to the side; negative behind.
double SearchMission::robot_ahead_m() const {
  const Pose2& person = seen_[kPerson]->map_from_agent;
  return (seen_[kRobot]->map_from_agent.position() - person.position()).dot(direction_of(person));
}

/// A robot that is to stay behind the person does not go farther than they are now, for as long as the next plan holds.
/// One that is ahead has to get out of there first. Gives true if that changes its ways.
bool SearchMission::close_what_is_ahead(Time now) {
  const bool was_closed = ahead_.has_value();
  ahead_.reset();
  if (keeps_robot_behind(now) && robot_ahead_m() <= 0.0) {
    const Pose2& person = seen_[kPerson]->map_from_agent;
    ahead_ = BlockedDisc{person.position() + kFar_m * direction_of(person), kFar_m};
  }
  return was_closed || ahead_.has_value();
}

void SearchMission::open_what_is_ahead() {
  if (!ahead_) return;
  ahead_.reset();
  computation_.reset();  // it plans on the ways that change
  if (world_ && seen_[kRobot]) find_ways_around_blockages();
}

/// Leads a robot that is ahead of the person to a place behind them; false if it is not ahead, or gets nowhere there.
bool SearchMission::lead_behind(SearchMember& robot) const {
  if (robot_ahead_m() <= 0.0) return false;
  const Pose2& person = seen_[kPerson]->map_from_agent;
  const Vector2d here = robot.pose.position();
  const auto way = way_between(kRobot, here, person.position() - kBehind_m * direction_of(person));
  if (!way) return false;
  append_way(robot.committed, *way, world_->searcher(robot.searcher), robot.pose.heading);
  return true;
}

}  // namespace tandem
