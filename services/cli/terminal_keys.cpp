#include "services/cli/terminal_keys.hpp"

#include <poll.h>
#include <unistd.h>

namespace tandem::cli {

TerminalKeys::TerminalKeys()
    : is_there_(isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp() &&
                tcgetattr(STDIN_FILENO, &before_) == 0) {
  if (!is_there_) return;
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // a key counts at once; Ctrl-C stays a signal
  keys.c_cc[VSUSP] = keys.c_cc[VQUIT] = _POSIX_VDISABLE;  // the others would leave the terminal like this
  tcsetattr(STDIN_FILENO, TCSANOW, &keys);
}

TerminalKeys::~TerminalKeys() {
  if (is_there_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

std::string TerminalKeys::typed() {
  pollfd keyboard{STDIN_FILENO, POLLIN, 0};
  if (!is_there_ || poll(&keyboard, 1, 0) <= 0) return "";
  char typed[64];
  const ssize_t count = read(STDIN_FILENO, typed, sizeof(typed));
  if (count > 0) return {typed, static_cast<std::size_t>(count)};
  is_there_ = false;  // the terminal is gone
  return "";
}

}  // namespace tandem::cli
