#include "services/cli/live_terminal.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tandem::cli {
namespace {

// Alternate screen, no cursor, no wrapping of lines; and back.
constexpr const char* kEnter = "\x1b[?1049h\x1b[?25l\x1b[?7l";
constexpr const char* kLeave = "\x1b[?7h\x1b[?25h\x1b[?1049l";

std::size_t rows_of_terminal() {
  winsize size{};
  ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
  return size.ws_row > 0 ? size.ws_row : 24;
}

}  // namespace

bool LiveTerminal::is_there() {
  return isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1;
}

LiveTerminal::LiveTerminal() {
  tcgetattr(STDIN_FILENO, &before_);
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // a key counts at once; Ctrl-C stays a signal
  keys.c_cc[VSUSP] = keys.c_cc[VQUIT] = _POSIX_VDISABLE;  // the others would leave the terminal like this
  tcsetattr(STDIN_FILENO, TCSANOW, &keys);
  std::fputs(kEnter, stdout);
  std::fflush(stdout);
}

LiveTerminal::~LiveTerminal() {
  std::fputs(kLeave, stdout);
  std::fflush(stdout);
  tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void LiveTerminal::draw(const std::vector<std::string>& lines) {
  const std::size_t rows = rows_of_terminal();
  std::string text = "\x1b[H";
  for (std::size_t i = 0; i < std::min(lines.size(), rows - 1); ++i) text += "\x1b[2K" + lines[i] + "\n";
  text += "\x1b[J";  // nothing below of what was longer before
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

std::optional<std::string> LiveTerminal::keys(Duration timeout) {
  pollfd keyboard{STDIN_FILENO, POLLIN, 0};
  const auto timeout_ms = std::chrono::duration_cast<std::chrono::milliseconds>(timeout).count();
  if (poll(&keyboard, 1, static_cast<int>(timeout_ms)) <= 0) return "";
  char typed[64];
  const ssize_t count = read(STDIN_FILENO, typed, sizeof(typed));
  if (count <= 0) return std::nullopt;
  return std::string{typed, static_cast<std::size_t>(count)};
}

std::string printable(const std::string& text) {
  std::string clean = text;
  std::replace_if(
      clean.begin(), clean.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return clean;
}

}  // namespace tandem::cli
