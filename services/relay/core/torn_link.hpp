#pragma once

#include <cstddef>
#include <optional>

#include "services/common/time.hpp"

namespace tandem {

/// Decides when the link is to be joined anew, because it is torn: heartbeats come, but the other host's readers and
/// writers have not all been found, and no more of them are.
///
/// Over a bad air links were seen that stayed so for a minute. Discovery in Fast DDS 2.9.1 that one side believes to be
/// complete, and the other waits for, would look like that; a new participant makes both begin again.
class TornLink {
 public:
  /// `unmatched`: topics for which the other host has not been found. True when the link is to be joined anew now.
  [[nodiscard]] bool add(Time now, bool is_up, std::size_t unmatched);

  static constexpr Duration kPatience = std::chrono::seconds{5};
  static constexpr Duration kLongestPatience = std::chrono::seconds{60};

 private:
  std::optional<Time> since_;  ///< when the number last became less
  std::size_t unmatched_ = 0;
  Duration patience_ = kPatience;
};

}  // namespace tandem
