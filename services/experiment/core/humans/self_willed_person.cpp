#include "services/experiment/core/humans/self_willed_person.hpp"

#include <utility>

namespace tandem::experiment {

using simulator::PhonePress;
using simulator::PhoneUserDecision;
using simulator::PhoneUserInput;

SelfWilledPerson::SelfWilledPerson(const SelfWilledHabits& habits, PersonWorld& world,
                                   std::unique_ptr<NextPlace> next_place)
    : habits_(habits), world_(world), next_place_(std::move(next_place)), memory_(world), my_pose_(habits.my_pose) {}

PhoneUserDecision SelfWilledPerson::step(const PhoneUserInput& input, Rng& rng) {
  PhoneUserDecision decision;
  if (!input.connected || input.search_over) {
    if (input.search_over) decision.new_route_in_map.emplace();
    return decision;
  }
  memory_.look(world_, input.map_from_person.position());
  if (auto pose = my_pose_.pressed(input, rng)) decision.messages.push_back(*pose);
  if (input.walking) {
    idle_since_.reset();
    return decision;
  }
  if (!idle_since_) idle_since_ = input.now;
  if (input.now - *idle_since_ >= from_seconds(habits_.thought_s)) go_somewhere(input, rng, decision);
  return decision;
}

void SelfWilledPerson::go_somewhere(const PhoneUserInput& input, Rng& rng, PhoneUserDecision& decision) {
  const std::string plan = input.plan ? input.plan->id : std::string{};
  if (announced_) {
    const bool heeded = !plan.empty() && plan != announced_->plan_before;
    if (!heeded && input.now - announced_->since < from_seconds(habits_.patience_s)) return;
    decision.new_route_in_map = std::move(announced_->way_in_map);
    announced_.reset();
    return;
  }
  const auto ways = world_.ways_from(input.map_from_person.position());
  const auto cell = ways ? next_place_->choose(*ways, world_, memory_, rng) : std::nullopt;
  auto way = cell ? world_.way(*ways, *cell) : std::vector<Eigen::Vector2d>{};
  if (way.empty()) {
    idle_since_ = input.now;  // thinks again
    return;
  }
  if (!habits_.announces) {
    decision.new_route_in_map = std::move(way);
    return;
  }
  decision.messages.push_back({PhonePress::MyGoal, way.back(), std::nullopt});
  decision.messages.push_back({PhonePress::Replan, std::nullopt, std::nullopt});
  announced_ = Announced{std::move(way), plan, input.now};
}

}  // namespace tandem::experiment
