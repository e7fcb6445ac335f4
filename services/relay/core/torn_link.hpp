#pragma once

#include <cstddef>
#include <optional>

#include "services/common/time.hpp"

namespace tandem {

/// What a relay knows of the relay of the other host.
struct OtherRelay {
  bool is_heard = false;      ///< its heartbeats come
  bool is_found = false;      ///< discovery knows readers or writers of it; in an outage not for longer than a lease
  std::size_t unmatched = 0;  ///< topics for which it has not been found
};

/// Decides when the link is to be joined anew, because it is torn:
///
/// - Heartbeats come, but the other host's readers and writers have not all been found, and no more of them are. Over a
///   bad air links were seen that stayed so for a minute. Discovery in Fast DDS 2.9.1 that one side believes to be
///   complete, and the other waits for, would look like that.
/// - No heartbeat comes, but the other relay is still announced. A forged sample does that: Fast DDS takes nothing more
///   of a writer until it has passed the highest number that was seen. In an outage announcements end as well, and the
///   other is forgotten after a lease, before the patience ends.
///
/// A new participant makes both begin again.
class TornLink {
 public:
  /// True when the link is to be joined anew now.
  [[nodiscard]] bool add(Time now, const OtherRelay& other);

  static constexpr Duration kPatience = std::chrono::seconds{5};
  static constexpr Duration kLongestPatience = std::chrono::seconds{60};

 private:
  std::optional<Time> since_;  ///< when it was torn as it is, or the number last became less
  OtherRelay last_;
  Duration patience_ = kPatience;
};

}  // namespace tandem
