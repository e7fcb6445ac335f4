#pragma once

#include <gtest/gtest.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "tests/support/process_use.hpp"

namespace tandem::test {

/// A program that runs until this object goes; it must then end well.
class Process {
 public:
  explicit Process(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    id_ = fork();
    if (id_ == 0) {
      close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // the sockets of the test are the test's
      execv(arguments[0], arguments.data());
      _exit(127);
    }
  }
  ~Process() {
    if (id_ < 0) return;
    kill(id_, SIGTERM);
    int status = 0;
    waitpid(id_, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Ends it as a crash does.
  void kill_at_once() {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
    id_ = -1;
  }

  [[nodiscard]] bool is_running() const { return id_ > 0 && waitpid(id_, nullptr, WNOHANG) == 0; }

  /// What it has in memory now [MB].
  [[nodiscard]] double memory_MB() const { return memory_MB_of(id_); }
  /// What it has used of a core so far [s].
  [[nodiscard]] double cpu_s() const { return cpu_s_of(id_); }

 private:
  pid_t id_ = -1;
};

}  // namespace tandem::test
