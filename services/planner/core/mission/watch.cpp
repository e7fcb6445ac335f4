#include "services/planner/core/mission/watch.hpp"

#include <algorithm>

namespace tandem {

void Watch::look(Time stamp, const Pose2& pose, Observability& observability, SearchBelief& belief) {
  if (last_ && stamp <= *last_) return;
  if (last_) {
    const double duration_s = to_seconds(std::min<Duration>(stamp - *last_, kLongestLook));
    belief.look(agent_, observability.seen_from(searcher_, pose), searcher_.detection_rate_per_s, duration_s);
  }
  last_ = stamp;
}

}  // namespace tandem
