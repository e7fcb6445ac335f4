#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <string>
#include <vector>

#include "services/common/clock.hpp"

namespace tandem::test {

/// A command of `tandem` on a pseudo terminal of 24 lines.
class OnTerminal {
 public:
  explicit OnTerminal(std::vector<std::string> words) {
    const winsize size{24, 120, 0, 0};
    int terminal = -1;
    EXPECT_EQ(openpty(&keyboard_, &terminal, nullptr, nullptr, &size), 0);
    tcgetattr(terminal, &before_);
    words.insert(words.begin(), "tandem");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
      login_tty(terminal);
      execv(TANDEM_BINARY_DIR "/bin/tandem", arguments.data());
      _exit(127);
    }
    terminal_ = terminal;
  }
  ~OnTerminal() {
    if (process_ > 0) kill(process_, SIGKILL);
    close(terminal_);
    close(keyboard_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  /// Reads what is drawn until `text` has come. False after ten seconds.
  bool shows(const std::string& text) {
    const SteadyClock clock;
    const Time end = clock.now() + std::chrono::seconds{10};
    while (drawn_.find(text) == std::string::npos && clock.now() < end) read_for(kPatience_ms);
    return drawn_.find(text) != std::string::npos;
  }
  /// Reads what has been drawn already, all since the start.
  const std::string& drawn() {
    read_for(0);
    return drawn_;
  }
  void press(char key) { EXPECT_EQ(write(keyboard_, &key, 1), 1); }
  void send_signal(int number) const { kill(process_, number); }
  /// Waits for the end; the exit code, or minus the signal.
  int exit_code() {
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) read_for(kPatience_ms);
    process_ = -1;
    read_for(kPatience_ms);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  [[nodiscard]] bool is_as_before() const {
    termios now{};
    tcgetattr(terminal_, &now);
    return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag &&
           now.c_cc[VSUSP] == before_.c_cc[VSUSP] && now.c_cc[VQUIT] == before_.c_cc[VQUIT];
  }

 private:
  static constexpr int kPatience_ms = 50;

  void read_for(int timeout_ms) {
    pollfd screen{keyboard_, POLLIN, 0};
    if (poll(&screen, 1, timeout_ms) <= 0) return;
    char buffer[4096];
    const ssize_t count = read(keyboard_, buffer, sizeof(buffer));
    if (count > 0) drawn_.append(buffer, static_cast<std::size_t>(count));
  }

  int keyboard_ = -1;
  int terminal_ = -1;
  pid_t process_ = -1;
  termios before_{};
  std::string drawn_;
};

/// The terminal is as it was, and so is its screen.
inline void expect_restored(OnTerminal& terminal) {
  EXPECT_TRUE(terminal.is_as_before());
  EXPECT_NE(terminal.drawn().rfind("\x1b[?7h\x1b[?25h\x1b[?1049l"), std::string::npos)
      << "the screen is not given back";
  EXPECT_EQ(terminal.drawn().find("\x1b[?1049h", terminal.drawn().rfind("\x1b[?1049l")), std::string::npos);
}

}  // namespace tandem::test
