#include "services/experiment/core/humans/human.hpp"

#include <stdexcept>
#include <utility>

#include "services/experiment/core/humans/self_willed_person.hpp"
#include "services/simulator/core/obedient_person.hpp"

namespace tandem::experiment {
namespace {

constexpr double kLaneOfViews = 1.7;      ///< lanes are so many ranges of sight apart: a little overlap
constexpr double kOwnOverhead_m = 1.5;    ///< of a walk, for who decides again at every place
constexpr double kGoalOverhead_m = 15.0;  ///< and for who has to say where they go: fewer, farther goals
constexpr double kLateSpeed = 0.6;        ///< of the speed of others

std::unique_ptr<simulator::PhoneUser> follower(double latency_min_s, double latency_max_s) {
  simulator::ObedientHabits habits;
  habits.latency_min_s = latency_min_s;
  habits.latency_max_s = latency_max_s;
  habits.my_pose = simulator::habit_of_volunteers();
  return std::make_unique<simulator::ObedientPerson>(habits);
}

std::unique_ptr<simulator::PhoneUser> self_willed(PersonWorld& world, std::unique_ptr<NextPlace> next_place,
                                                  bool announces) {
  SelfWilledHabits habits;
  habits.announces = announces;
  return std::make_unique<SelfWilledPerson>(habits, world, std::move(next_place));
}

}  // namespace

const std::vector<std::string>& human_names() {
  static const std::vector<std::string> names{"obedient", "late", "own", "stubborn", "random", "announces"};
  return names;
}

Human make_human(std::string_view name, PersonWorld& world, double speed_mps) {
  if (name == "obedient") return {follower(3.0, 8.0), speed_mps};
  if (name == "late") return {follower(8.0, 20.0), kLateSpeed * speed_mps};
  if (name == "own") return {self_willed(world, greedy_place(kOwnOverhead_m), false), speed_mps};
  if (name == "stubborn") {
    return {self_willed(world, lawnmower_place(kLaneOfViews * world.view_range_m()), false), speed_mps};
  }
  if (name == "random") return {self_willed(world, random_place(), false), speed_mps};
  if (name == "announces") return {self_willed(world, greedy_place(kGoalOverhead_m), true), speed_mps};
  std::string known;
  for (const std::string& each : human_names()) known += (known.empty() ? "" : ", ") + each;
  throw std::invalid_argument("there is no human called \"" + std::string{name} + "\"; there are " + known);
}

}  // namespace tandem::experiment
