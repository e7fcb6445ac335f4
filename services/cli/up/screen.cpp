#include "services/cli/up/screen.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tandem::cli {

Screen::Screen(bool headless) : live_(!headless && isatty(STDOUT_FILENO) == 1) {}

void Screen::show(const EpisodeView& view, Time now) {
  const bool phase_changed = view.phase != last_phase_;
  if (now < next_ && !phase_changed) return;
  last_phase_ = view.phase;
  next_ = now + (live_ ? std::chrono::milliseconds{500} : std::chrono::milliseconds{10'000});
  if (live_) {
    draw(view);
  } else {
    std::printf("%s\n", summary_line(view).c_str());
    std::fflush(stdout);
  }
}

void Screen::finish(const EpisodeView& view) {
  if (live_) draw(view);
}

void Screen::draw(const EpisodeView& view) {
  winsize size{};
  ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
  const int columns = size.ws_col > 0 ? size.ws_col : 80;
  const int rows = size.ws_row > 0 ? size.ws_row : 24;
  const auto lines = lines_of(view, std::min(columns, 100), std::max(0, rows - 10));
  if (drawn_lines_ > 0) std::printf("\x1b[%dA", drawn_lines_);
  // A line too long for the terminal is cut: wrapped, it would shift everything the next drawing goes over.
  std::printf("\x1b[?7l");
  for (const auto& line : lines) std::printf("\x1b[2K%s\n", line.c_str());
  std::printf("\x1b[?7h");
  drawn_lines_ = static_cast<int>(lines.size());
  std::fflush(stdout);
}

void Screen::say(const std::string& text) {
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  drawn_lines_ = 0;
}

void Screen::report(const EpisodeView& view, const std::string& reason, const std::string& recording,
                    const std::string& picture, double processor_cores) {
  if (view.found_at) {
    std::printf("Found by %s after %.0f s at (%.1f, %.1f) m.\n", view.found_by.c_str(), view.time_s, view.found_at->x(),
                view.found_at->y());
  } else {
    std::printf("Not found: %s (after %.0f s).\n", reason.c_str(), view.time_s);
  }
  std::printf("Explored %.0f %%: robot %.0f %%, person %.0f %%. %d messages, %d stops. %.2f cores busy.\n",
              100.0 * view.explored, 100.0 * view.explored_robot, 100.0 * view.explored_human, view.messages,
              view.stops, processor_cores);
  std::printf("Recording: %s\nPicture:   %s\n", recording.c_str(), picture.c_str());
  std::fflush(stdout);
}

}  // namespace tandem::cli
