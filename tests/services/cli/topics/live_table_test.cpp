// The command as a process, at a terminal of its own and without one.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <string>

#include "services/bus/bus.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::cli {
namespace {

using std::chrono::seconds;

/// `tandem topics` on a pseudo terminal of 24 lines.
class OnTerminal {
 public:
  explicit OnTerminal(int domain) {
    const winsize size{24, 100, 0, 0};
    int terminal = -1;
    EXPECT_EQ(openpty(&keyboard_, &terminal, nullptr, nullptr, &size), 0);
    tcgetattr(terminal, &before_);
    process_ = fork();
    if (process_ == 0) {
      login_tty(terminal);
      const std::string number = std::to_string(domain);
      execl(TANDEM_BINARY_DIR "/bin/tandem", "tandem", "topics", "--watch", "--domain", number.c_str(), nullptr);
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
    const Time end = clock.now() + seconds{10};
    while (drawn_.find(text) == std::string::npos && clock.now() < end) read_some();
    return drawn_.find(text) != std::string::npos;
  }
  void press(char key) { EXPECT_EQ(write(keyboard_, &key, 1), 1); }
  /// Waits for the end; the exit code, or minus the signal.
  int exit_code() {
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) read_some();
    process_ = -1;
    read_some();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  [[nodiscard]] bool is_as_before() const {
    termios now{};
    tcgetattr(terminal_, &now);
    return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag;
  }
  [[nodiscard]] const std::string& drawn() const { return drawn_; }

 private:
  void read_some() {
    pollfd screen{keyboard_, POLLIN, 0};
    if (poll(&screen, 1, 50) <= 0) return;
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

/// Somebody to be shown.
bus::DomainOptions base_in(int domain) {
  bus::DomainOptions options;
  options.domain = domain;
  options.participant = "base@robot1";
  return options;
}

void expect_restored(const OnTerminal& terminal) {
  EXPECT_TRUE(terminal.is_as_before());
  const auto& drawn = terminal.drawn();
  EXPECT_TRUE(drawn.ends_with("\x1b[?7h\x1b[?25h\x1b[?1049l")) << "the screen is not given back";
}

TEST(LiveTable, ShowsWhoIsThereUntilQAndRestoresTheTerminal) {
  const test::DomainLease domain{1};
  bus::Bus base{base_in(domain[0])};
  auto odometry = base.writer(topic::kOdometry);
  OnTerminal terminal{domain[0]};
  EXPECT_TRUE(terminal.shows("odometry  robot1  base"));
  EXPECT_FALSE(terminal.is_as_before());
  terminal.press('q');
  EXPECT_EQ(terminal.exit_code(), 0);
  expect_restored(terminal);
}

TEST(LiveTable, CtrlCEndsItAsWell) {
  const test::DomainLease domain{1};
  OnTerminal terminal{domain[0]};
  EXPECT_TRUE(terminal.shows("Nobody is here"));
  terminal.press(3);  // the terminal makes it SIGINT
  EXPECT_EQ(terminal.exit_code(), 0);
  expect_restored(terminal);
}

TEST(LiveTable, IsPlainTextWhereThereIsNoTerminal) {
  const test::DomainLease domain{1};
  bus::Bus base{base_in(domain[0])};
  auto odometry = base.writer(topic::kOdometry);
  const std::string command = TANDEM_BINARY_DIR "/bin/tandem topics --watch --seconds 4.5 --domain " +
                              std::to_string(domain[0]) + " < /dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  char buffer[4096];
  while (const auto count = fread(buffer, 1, sizeof(buffer), pipe)) output.append(buffer, count);
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(output.find('\x1b'), std::string::npos);
  std::size_t tables = 0;
  for (auto at = output.find("TOPIC"); at != std::string::npos; at = output.find("TOPIC", at + 1)) ++tables;
  EXPECT_GE(tables, 2U) << output;
}

}  // namespace
}  // namespace tandem::cli
