#include "services/relay/core/torn_link.hpp"

#include <algorithm>

namespace tandem {

bool TornLink::add(Time now, bool is_up, std::size_t unmatched) {
  if (!is_up || unmatched == 0) {
    since_.reset();
    if (is_up) patience_ = kPatience;
    return false;
  }
  if (!since_ || unmatched < unmatched_) since_ = now;
  unmatched_ = unmatched;
  if (now - *since_ < patience_) return false;
  since_.reset();
  patience_ = std::min(2 * patience_, kLongestPatience);  // the other may never have them: another program
  return true;
}

}  // namespace tandem
