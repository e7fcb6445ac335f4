#pragma once

#include <compare>
#include <string>

namespace tandem::bus {

/// What somebody else on the bus does wrong, as log, service_health and `tandem topics` name it.
struct PeerFault {
  std::string id;    ///< "X3": the row of docs/network.md, "Wrong peers"
  std::string what;  ///< for people: what is wrong, where, by whom

  auto operator<=>(const PeerFault&) const = default;
};

/// "X3: wrong type on team_plan: ...".
[[nodiscard]] inline std::string text_of(const PeerFault& fault) {
  return fault.id + ": " + fault.what;
}

}  // namespace tandem::bus
