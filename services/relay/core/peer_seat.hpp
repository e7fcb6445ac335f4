#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/common/time.hpp"

namespace tandem {

/// The place of the other host of a team, which two hosts must not have at once: two laptops of one robot, two robots
/// of one name.
///
/// Two hosts count as two only if each was heard after the other had been: one that follows upon another is one.
class PeerSeat {
 public:
  /// A host that was silent for longer has left.
  static constexpr Duration kSilence = std::chrono::seconds{3};

  /// `host` was heard at `now` and would be our peer. The other host that has the place as well, if one does.
  [[nodiscard]] std::optional<std::string> rival_of(const std::string& host, Time now);

 private:
  struct Claim {
    Time first{};
    Time last{};
  };
  std::map<std::string, Claim> claims_;
};

}  // namespace tandem
