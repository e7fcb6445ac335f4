#include "services/planner/core/mission/plan_explanation.hpp"

#include <cctype>
#include <cmath>

namespace tandem {
namespace {

std::string whole(double number) {
  return std::to_string(std::lround(number));
}

std::string way(double way_m, bool goal_fixed, const std::string& goal) {
  if (way_m < 0.5) return "stays here";
  return "goes " + whole(way_m) + " m" + (goal_fixed ? " to " + goal : "");
}

}  // namespace

std::string explanation_of(const PlanFacts& facts) {
  std::string text = facts.occasion;
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  text += ". The robot " + way(facts.robot_way_m, facts.robot_goal_fixed, "the goal you gave it");
  if (facts.person_way_m) {
    const bool stays = *facts.person_way_m < 0.5;
    text += stays ? ", you stay here"
                  : ", you go " + whole(*facts.person_way_m) + " m" + (facts.person_goal_fixed ? " to your goal" : "");
  }
  text += ": found with " + whole(100.0 * facts.probability_found) + " % within " + whole(facts.horizon_s) + " s";
  if (facts.without_person_s && *facts.without_person_s >= 0.5) {
    text += "; if you stayed where you are it would take " + whole(*facts.without_person_s) + " s longer";
  }
  return text + ".";
}

}  // namespace tandem
