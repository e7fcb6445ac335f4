#pragma once

#include <string>

#include "services/cli/up/episode_view.hpp"
#include "services/common/time.hpp"

namespace tandem::cli {

/// Shows an episode while it runs: a live picture on a terminal, a line every few seconds elsewhere.
class Screen {
 public:
  explicit Screen(bool headless);
  void show(const EpisodeView& view, Time now);
  /// The last picture stays.
  void finish(const EpisodeView& view);
  /// A message between the pictures.
  void say(const std::string& text);
  /// The result, in words.
  void report(const EpisodeView& view, const std::string& reason, const std::string& recording,
              const std::string& picture, double processor_cores);

 private:
  void draw(const EpisodeView& view);

  bool live_;
  int drawn_lines_ = 0;
  Time next_{};
  std::string last_phase_;
};

}  // namespace tandem::cli
