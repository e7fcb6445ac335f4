#pragma once

#include <optional>

#include "services/common/time.hpp"
#include "services/planner/core/search/search_belief.hpp"

namespace tandem {

/// Credits the belief with what one agent sees from where it is believed to be.
class Watch {
 public:
  Watch(std::size_t agent, const Searcher& searcher) : agent_(agent), searcher_(searcher) {}

  /// The agent is at `pose` at `stamp`, and has seen that way since the last call, but for no longer than
  /// `kLongestLook`: what happened in a longer gap is not known.
  void look(Time stamp, const Pose2& pose, Observability& observability, SearchBelief& belief);
  /// It looked away: the time until the next look is no look.
  void pause() { last_.reset(); }

  static constexpr Duration kLongestLook = std::chrono::milliseconds{1000};

 private:
  std::size_t agent_;
  Searcher searcher_;
  std::optional<Time> last_;
};

}  // namespace tandem
