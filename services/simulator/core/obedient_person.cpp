#include "services/simulator/core/obedient_person.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::simulator {
namespace {

/// `path` from the point nearest to `here` on: what lies behind is not walked again.
std::vector<Eigen::Vector2d> rest_of(const std::vector<Eigen::Vector2d>& path, const Eigen::Vector2d& here) {
  const auto nearest = std::min_element(path.begin(), path.end(), [&](const auto& a, const auto& b) {
    return (a - here).squaredNorm() < (b - here).squaredNorm();
  });
  const bool more = nearest != path.end() && nearest + 1 != path.end();
  return {more ? nearest + 1 : nearest, path.end()};
}

}  // namespace

PhoneUserDecision ObedientPerson::step(const PhoneUserInput& input, Rng& rng) {
  PhoneUserDecision decision;
  if (!input.connected || input.search_over || found_) {
    if (input.search_over || found_) decision.new_route_in_map.emplace();
    decision.found = found_;
    return decision;
  }
  if (input.visible_token_in_map) {
    const double seen = 1.0 - std::exp(-habits_.detection_rate_per_s * input.dt_s);
    if (rng.uniform() < seen) {
      found_ = decision.found = true;
      decision.messages.push_back({PhonePress::Found, *input.visible_token_in_map, std::nullopt});
      decision.new_route_in_map.emplace();
      return decision;
    }
  }
  if (auto pose = my_pose_.pressed(input, rng)) decision.messages.push_back(*pose);
  if (!greeted_) {
    greeted_ = true;
    decision.messages.push_back({PhonePress::Replan, std::nullopt, std::nullopt});
    last_replan_ = idle_since_ = input.now;
    return decision;
  }
  react_to_plan(input, rng, decision);
  ask_for_plan(input, decision);
  return decision;
}

void ObedientPerson::react_to_plan(const PhoneUserInput& input, Rng& rng, PhoneUserDecision& decision) {
  if (!input.plan || input.plan->own_path_in_map.empty()) return;
  if (input.plan->id != noticed_plan_) {
    noticed_plan_ = input.plan->id;
    walks_at_ = input.now + from_seconds(rng.uniform(habits_.latency_min_s, habits_.latency_max_s));
  }
  if (noticed_plan_ == walked_plan_ || input.now < walks_at_) return;
  walked_plan_ = noticed_plan_;
  decision.new_route_in_map = rest_of(input.plan->own_path_in_map, input.map_from_person.position());
}

void ObedientPerson::ask_for_plan(const PhoneUserInput& input, PhoneUserDecision& decision) {
  const bool about_to_walk = noticed_plan_ != walked_plan_;
  if (input.walking || about_to_walk || decision.new_route_in_map) {
    idle_since_ = input.now;
    return;
  }
  const Duration since_replan = input.now - last_replan_;
  const bool waited = (input.now - idle_since_ >= from_seconds(habits_.patience_s) &&
                       since_replan >= from_seconds(habits_.replan_interval_s)) ||
                      (input.replan_refused && since_replan >= from_seconds(habits_.retry_s));
  if (!waited || input.computing) return;
  decision.messages.push_back({PhonePress::Replan, std::nullopt, std::nullopt});
  last_replan_ = input.now;
}

}  // namespace tandem::simulator
