// The part of SearchMission that decides what the person is told.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "services/planner/core/inform/own_way.hpp"
#include "services/planner/core/mission/search_mission.hpp"

namespace tandem {
namespace {

constexpr Duration kPeriod = std::chrono::seconds{5};  ///< between two looks at what could be told
constexpr double kAhead_s = 30.0;                      ///< so far ahead one who goes straight on is followed
constexpr double kWorthSaying_m2 = 1.0;
constexpr std::string_view kBeliefId = "where it may be";

std::string whole(double number) {
  return std::to_string(std::lround(number));
}

}  // namespace

/// A new search: the person knows what the robot knows, and nothing has been told.
void SearchMission::begin_knowledge() {
  knowledge_.emplace(*belief_, Watch{kRobot, robot_of(config_, agents_[kRobot])},
                     Watch{kPerson, person_of(config_, agents_[kPerson])});
  informs_ = InformSchedule({config_.inform_cost_s, config_.inform_pause_s, config_.inform_life_s});
  inform_.reset();
  inform_due_ = Time{};
}

/// Telling gains only as far as the person goes their own way: the plan, which they follow else, knows everything.
void SearchMission::consider_informing(Time now) {
  if (!plan_ || now < inform_due_ || !person_is_known(now)) return;
  const double own_way = goals_[kPerson] ? 1.0 : habits_.stray_probability();
  if (own_way <= 0.0) return;
  inform_due_ = now + kPeriod;
  std::vector<InformOption> options{belief_option(now, own_way)};
  for (const SourceEdit& drawn : drawn_) {
    if (auto option = source_option(drawn, own_way)) options.push_back(*std::move(option));
  }
  if (const auto chosen = informs_.next(options, now)) {
    inform_ = PersonInform{++inform_number_, chosen->source_id, chosen->reason};
  }
}

void SearchMission::inform_heard(std::uint64_t number) {
  if (!inform_ || inform_->number != number) return;
  const std::string& id = inform_->source_id;
  id == kBeliefId ? knowledge_->learns(*belief_) : knowledge_->learns(id);
  informs_.heard(id);
}

/// Where the object may be: what the robot looked at out of their sight, and what others said.
InformOption SearchMission::belief_option(Time now, double own_way) {
  SearchProblem problem;
  problem.world = world_.get();
  problem.masses = {belief_->posterior()};
  problem.horizon_s = config_.horizon_s;
  problem.tail_s = world_->sweep_time_s({static_cast<int>(kRobot), static_cast<int>(kPerson)});
  SearchMember person;
  person.searcher = static_cast<int>(kPerson);
  person.pose = seen_[kPerson]->map_from_agent;
  problem.members.push_back(person);
  const auto rest = rest_of_plan(now);
  if (!rest.empty()) {
    problem.others.push_back({static_cast<int>(kRobot), seen_[kRobot]->map_from_agent.heading, rest[kRobot]});
  }
  InformOption option{std::string{kBeliefId}, own_way * gain_of_knowing_s(problem, knowledge_->belief().posterior()),
                      ""};
  double unknown_m2 = 0.0;
  for (int cell = 0; cell < world_->area().size(); ++cell) {
    const bool is_news = belief_->is_explored(cell, config_.explored_probability) &&
                         !knowledge_->belief().is_explored(cell, config_.explored_probability);
    if (is_news) unknown_m2 += world_->area().floor_m2(cell);
  }
  option.reason = unknown_m2 >= kWorthSaying_m2
                      ? "The robot has searched " + whole(unknown_m2) + " m² that you have not"
                      : "It is known better where the object may be";
  option.reason += ": look where the map is purple.";
  return option;
}

/// A place drawn by somebody else that they are to keep out of. Where they are to go the plan tells them.
std::optional<InformOption> SearchMission::source_option(const SourceEdit& drawn, double own_way) const {
  const auto course = habits_.course();
  if (drawn.kind != SourceEdit::Kind::Avoid || !concerns(drawn, kPerson) || knowledge_->knows(drawn.source_id)) {
    return std::nullopt;
  }
  if (!course) return std::nullopt;
  const Eigen::Vector2d person_in_map = seen_[kPerson]->map_from_agent.position();
  const double inside_s =
      time_walked_into_s(world_->map(0), drawn.region, person_in_map, *course, config_.person_speed_mps, kAhead_s);
  const double cost_per_s = -peak_of(drawn_source(drawn).inside);
  const double away_m = (inner_point(drawn.region) - person_in_map).norm();
  const std::string by = drawn.who.empty() ? "Somebody" : drawn.who;
  return InformOption{drawn.source_id, own_way * cost_per_s * inside_s,
                      by + " has drawn a place to keep out of, " + whole(away_m) + " m ahead of you."};
}

}  // namespace tandem
