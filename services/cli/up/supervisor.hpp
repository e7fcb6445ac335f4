#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::cli {

/// A program to run and where its log goes.
struct ProcessPlan {
  std::string name;  ///< "robot/base", for people
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::filesystem::path log_file;  ///< standard output and error
};

/// How a process ended.
struct ProcessEnd {
  std::string name;
  int code = 0;          ///< exit code, or 128 + signal
  std::string last_log;  ///< its last line, to tell why
};

/// Runs programs as children that never outlive it: the kernel kills them when it dies.
class Supervisor {
 public:
  Supervisor() = default;
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Throws std::runtime_error when the program cannot be started.
  void start(const ProcessPlan& plan);
  /// Processes that ended by themselves since the last call.
  std::vector<ProcessEnd> ended();
  /// Asks the newest first to end, gives each round `patience`, then kills. Reaps all.
  void stop_all(Duration patience);
  /// Sends `signal` to the process; false if there is none of that name.
  bool signal(const std::string& name, int signal);
  [[nodiscard]] bool is_running(const std::string& name) const;
  /// None if no process of that name runs.
  [[nodiscard]] std::optional<pid_t> id_of(const std::string& name) const;
  [[nodiscard]] std::filesystem::path log_of(const std::string& name) const;
  /// Processor time [s] of all children that were reaped.
  [[nodiscard]] static double processor_seconds();

 private:
  struct Child {
    ProcessPlan plan;
    pid_t pid = -1;
  };
  std::vector<Child> children_;
};

/// The last non-empty line of a log file; empty if there is none.
[[nodiscard]] std::string last_line(const std::filesystem::path& file);

}  // namespace tandem::cli
