#include "services/cli/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tandem::cli {
namespace {
constexpr int kWidth = 30;
constexpr Duration kQuietAtFirst = std::chrono::seconds{1};
constexpr Duration kBetweenDrawings = std::chrono::milliseconds{100};
}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), started_(clock_.now()), drawn_(started_), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) std::fprintf(stderr, "\r\033[K");
}

void Progress::show(double share, const std::string& note) {
  if (!on_terminal_) return;
  const Time now = clock_.now();
  if (now - started_ < kQuietAtFirst || now - drawn_ < kBetweenDrawings) return;
  drawn_ = now;
  visible_ = true;
  const int full = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kWidth));
  const std::string bar =
      std::string(static_cast<std::size_t>(full), '#') + std::string(static_cast<std::size_t>(kWidth - full), '.');
  std::fprintf(stderr, "\r%s [%s] %3d %%  %s\033[K", what_.c_str(), bar.c_str(), full * 100 / kWidth, note.c_str());
  std::fflush(stderr);
}

}  // namespace tandem::cli
