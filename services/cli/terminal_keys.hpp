#pragma once

#include <termios.h>

#include <string>

namespace tandem::cli {

/// Keys as they are typed, beside ordinary output; the terminal is as before once this object goes. Where standard
/// input is no terminal, or another program's in the foreground, there are none.
class TerminalKeys {
 public:
  TerminalKeys();
  ~TerminalKeys();
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

  [[nodiscard]] bool is_there() const { return is_there_; }
  /// What was typed since the last call. Does not wait.
  [[nodiscard]] std::string typed();

 private:
  bool is_there_;
  termios before_{};
};

}  // namespace tandem::cli
