#pragma once

namespace tandem {

/// While it lives, SIGINT and SIGTERM ask the program to end in order instead of killing it. One per process.
class StopSignal {
 public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  [[nodiscard]] bool requested() const;
};

}  // namespace tandem
