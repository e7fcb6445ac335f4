// The part of SearchMission that does what a person says of the belief or draws on the map, and finds ways around it.
#include <algorithm>
#include <utility>

#include "services/planner/core/mission/computation.hpp"
#include "services/planner/core/srs/search_sources.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kStartReach_m = 3.0;

}  // namespace

std::optional<std::string> SearchMission::edit_belief(const BeliefEdit& edit) {
  if (!running_ || !belief_) return "the search has not begun";
  if (activity_ == MissionActivity::Finished) return "the search is over";
  if (auto refusal = tandem::edit_belief(*belief_, world_->area(), edit, kPerson)) return refusal;
  if (edit.who == agents_[kPerson]) knowledge_->says(edit, world_->area(), kPerson);
  person_said_where_ = true;
  begin_computing_anew();
  ++world_version_;
  return std::nullopt;
}

/// What is being computed does not know of an edit. It is begun anew, but only once: another edit waits for the next
/// plan, so that there is a plan however fast edits follow each other.
void SearchMission::begin_computing_anew() {
  if (!computation_) return;
  if (begun_anew_) {
    computation_->overtaken = true;
  } else {
    stop_computing();
    begun_anew_ = true;
  }
}

std::optional<std::string> SearchMission::edit_source(const SourceEdit& edit, Time now) {
  if (auto problem = problem_of(edit, agents_)) return problem;
  if (edit.kind == SourceEdit::Kind::Remove) return remove_source(edit.source_id);
  if (!world_) return "the map is not known yet";
  const auto current = sources();
  if (std::ranges::find(current, edit.source_id, &RewardSource::id) != current.end() || edit.source_id == kFoundId) {
    return "there is a source of this id already";
  }
  auto refusal = edit.kind == SourceEdit::Kind::GoTo          ? go_to(edit, now)
                 : edit.kind == SourceEdit::Kind::PassThrough ? pass_through(edit)
                 : edit.kind == SourceEdit::Kind::StayBehind  ? stay_behind(edit)
                                                              : keep_out(edit);
  if (refusal) return refusal;
  if (edit.who == agents_[kPerson]) knowledge_->learns(edit.source_id);
  const bool closes = edit.kind == SourceEdit::Kind::Avoid || edit.kind == SourceEdit::Kind::StayBehind;
  if (closes && plan_enters(drawn_.back(), now)) acceptance_.withdraw();
  person_drew_ = true;
  begin_computing_anew();
  ++world_version_;
  return std::nullopt;
}

std::vector<RewardSource> SearchMission::sources() const {
  std::vector<RewardSource> sources;
  for (const std::size_t member : {kRobot, kPerson}) {
    if (goals_[member]) sources.push_back(goal_source(agents_[member], *goals_[member], config_.goal_reach_m));
  }
  for (const SourceEdit& drawn : drawn_) sources.push_back(drawn_source(drawn));
  return sources;
}

std::vector<Relation> SearchMission::relations() const {
  std::vector<Relation> relations;
  for (const SourceEdit& drawn : drawn_) {
    const bool goes_to = drawn.kind == SourceEdit::Kind::GoTo;
    if (!goes_to && drawn.kind != SourceEdit::Kind::PassThrough) continue;
    const std::string& target = drawn.targets.front();
    if (!goals_[target == agents_[kRobot] ? kRobot : kPerson]) continue;
    Relation relation;
    relation.kind = goes_to ? RelationKind::Codependent : RelationKind::Soft;
    relation.from = drawn.source_id;
    relation.to = goal_source(target, Vector2d::Zero(), config_.goal_reach_m).id;
    relations.push_back(relation);
  }
  return relations;
}

bool SearchMission::concerns(const SourceEdit& edit, std::size_t member) const {
  return edit.targets.empty() || std::ranges::find(edit.targets, agents_[member]) != edit.targets.end();
}

/// Whether somebody whom the edit concerns would still walk into its region.
bool SearchMission::plan_enters(const SourceEdit& edit, Time now) const {
  constexpr double kStep_s = 0.2;
  for (std::size_t m = 0; plan_ && m < plan_->members.size(); ++m) {
    if (!concerns(edit, m)) continue;
    const TimedPath& path = plan_->members[m].path;
    for (double time_s = std::max(0.0, elapsed_s(now)); time_s <= path.duration_s(); time_s += kStep_s) {
      if (contains(edit.region, pose_at(path, time_s).position())) return true;
    }
  }
  return false;
}

std::vector<BlockedDisc> SearchMission::kept_out_of(std::size_t member) const {
  std::vector<BlockedDisc> discs;
  for (const SourceEdit& drawn : drawn_) {
    if (drawn.kind != SourceEdit::Kind::Avoid || !concerns(drawn, member)) continue;
    const auto cover = covering_discs(drawn.region);
    discs.insert(discs.end(), cover.begin(), cover.end());
  }
  if (member == kRobot && ahead_) discs.push_back(*ahead_);
  return discs;
}

void SearchMission::find_ways_anew(std::size_t member, const std::vector<BlockedDisc>& blocked) {
  const Vector2d start = seen_[seen_[member] ? member : kRobot]->map_from_agent.position();
  world_->block(static_cast<int>(member), blocked, start);
}

bool SearchMission::gets_somewhere(std::size_t member) {
  if (!seen_[member]) return true;
  ActionSet& actions = world_->actions(static_cast<int>(member));
  const auto start = actions.add_place(seen_[member]->map_from_agent.position(), kStartReach_m);
  return start && !actions.nearest_lookouts(*start).empty();
}

/// Finds the robot's ways around what is blocked; if that shuts it in, it must try again through what was blocked, and
/// then through what lies ahead of the person.
void SearchMission::find_ways_around_blockages() {
  std::vector<BlockedDisc> discs = kept_out_of(kRobot);
  for (const auto& entry : blocked_) discs.push_back(entry.second);
  find_ways_anew(kRobot, discs);
  ++world_version_;
  if (discs.empty() || gets_somewhere(kRobot)) return;
  blocked_.clear();
  find_ways_anew(kRobot, kept_out_of(kRobot));
  if (!ahead_ || gets_somewhere(kRobot)) return;
  ahead_.reset();
  find_ways_anew(kRobot, kept_out_of(kRobot));
}

/// Finds the ways of those whom a drawn source concerns.
void SearchMission::renew_ways(const SourceEdit& edit) {
  if (edit.kind != SourceEdit::Kind::Avoid) return;
  stop_computing();  // it plans on the ways that change
  if (concerns(edit, kRobot)) find_ways_around_blockages();
  if (concerns(edit, kPerson)) find_ways_anew(kPerson, kept_out_of(kPerson));
}

std::optional<std::string> SearchMission::keep_out(const SourceEdit& edit) {
  for (const std::size_t member : {kRobot, kPerson}) {
    if (concerns(edit, member) && seen_[member] && contains(edit.region, seen_[member]->map_from_agent.position())) {
      return agents_[member] + " stands there";
    }
  }
  drawn_.push_back(edit);
  renew_ways(edit);
  for (const std::size_t member : {kRobot, kPerson}) {
    if (!concerns(edit, member) || gets_somewhere(member)) continue;
    drawn_.pop_back();
    renew_ways(edit);
    return agents_[member] + " would not get anywhere any more";
  }
  return std::nullopt;
}

std::optional<std::string> SearchMission::go_to(const SourceEdit& edit, Time now) {
  const bool is_robot = edit.targets.front() == agents_[kRobot];
  const auto kind = is_robot ? PersonRequest::Kind::RobotGoal : PersonRequest::Kind::MyGoal;
  if (auto refusal = request({kind, inner_point(edit.region)}, now)) return refusal;
  drawn_.push_back(edit);
  return std::nullopt;
}

std::optional<std::string> SearchMission::remove_source(const std::string& id) {
  const auto found = std::ranges::find(drawn_, id, &SourceEdit::source_id);
  if (found == drawn_.end()) return "nothing of this id is drawn";
  const SourceEdit edit = *found;
  drawn_.erase(found);
  knowledge_->forgets(id);
  informs_.forget(id);
  begin_computing_anew();
  person_drew_ = true;
  ++world_version_;
  renew_ways(edit);
  if (edit.kind == SourceEdit::Kind::StayBehind) open_what_is_ahead();
  for (const std::size_t member : {kRobot, kPerson}) {
    if (edit.kind == SourceEdit::Kind::GoTo && concerns(edit, member)) goals_[member].reset();
  }
  return std::nullopt;
}

/// Of places to go to only the last one counts, as of goals.
void SearchMission::forget_drawn_goals(std::size_t member) {
  std::erase_if(
      drawn_, [&](const SourceEdit& drawn) { return drawn.kind == SourceEdit::Kind::GoTo && concerns(drawn, member); });
}

void SearchMission::forget_drawn() {
  person_drew_ = false;
  for (const SourceEdit& edit : std::exchange(drawn_, {})) {
    if (world_) renew_ways(edit);
  }
  open_what_is_ahead();
}

}  // namespace tandem
