#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace tandem::test {

/// What a process has used of a core so far [s].
[[nodiscard]] inline double cpu_s_of(pid_t id) {
  std::ifstream file{"/proc/" + std::to_string(id) + "/stat"};
  std::string line;
  std::getline(file, line);
  std::istringstream fields{line.substr(line.rfind(')') + 2)};  // the name in brackets may hold anything
  std::string skipped;
  for (int i = 3; i < 14; ++i) fields >> skipped;
  double user = 0.0;
  double system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// What a process has in memory now [MB].
[[nodiscard]] inline double memory_MB_of(pid_t id) {
  std::ifstream file{"/proc/" + std::to_string(id) + "/statm"};
  double whole = 0.0;
  double resident = 0.0;
  file >> whole >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

}  // namespace tandem::test
