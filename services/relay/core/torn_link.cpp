#include "services/relay/core/torn_link.hpp"

#include <algorithm>

namespace tandem {

bool TornLink::add(Time now, const OtherRelay& other) {
  const bool is_whole = other.is_heard && other.unmatched == 0;
  const bool is_away = !other.is_heard && !other.is_found;
  if (is_whole) patience_ = kPatience;
  if (is_whole || is_away) {
    since_.reset();
    return false;
  }
  const bool is_mending = other.unmatched < last_.unmatched;
  if (!since_ || is_mending || other.is_heard != last_.is_heard) since_ = now;
  last_ = other;
  if (now - *since_ < patience_) return false;
  since_.reset();
  patience_ = std::min(2 * patience_, kLongestPatience);  // the other may never have them: another program
  return true;
}

}  // namespace tandem
