#include "services/cli/replay_keys.hpp"

namespace tandem::cli {

using recorder::ReplayWish;

ReplayWish ReplayKeys::wish_after(const std::string& typed) {
  for (const char key : typed) {
    if (key == 'q') return ReplayWish::End;
    if (key == ' ') {
      is_paused_ = !is_paused_;
      steps_ = 0;
    } else if (key == '.') {
      is_paused_ = true;
      ++steps_;
    }
  }
  if (!is_paused_) return ReplayWish::Play;
  if (steps_ == 0) return ReplayWish::Pause;
  --steps_;
  return ReplayWish::Step;
}

}  // namespace tandem::cli
