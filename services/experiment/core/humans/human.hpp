#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "services/experiment/core/humans/person_world.hpp"
#include "services/simulator/core/phone_user.hpp"

namespace tandem::experiment {

/// A person of the study: how they decide, and how fast they walk.
struct Human {
  std::unique_ptr<simulator::PhoneUser> mind;
  double speed_mps = 0.75;
};

/// The kinds of people that there are, in the order of docs/study.md: obedient, late, own, stubborn, random, announces.
[[nodiscard]] const std::vector<std::string>& human_names();

/// The person of that kind, who walks at `speed_mps` when in no way hindered; `world` must outlive them.
///
/// Throws std::invalid_argument, naming the kinds there are, for a name that is none.
[[nodiscard]] Human make_human(std::string_view name, PersonWorld& world, double speed_mps);

}  // namespace tandem::experiment
