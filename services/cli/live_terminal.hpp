#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <vector>

#include "services/common/time.hpp"

namespace tandem::cli {

/// A whole terminal that is drawn over and over; as it was before, once this object goes, however that comes about.
class LiveTerminal {
 public:
  /// True where both ends are a terminal.
  [[nodiscard]] static bool is_there();

  LiveTerminal();
  ~LiveTerminal();
  LiveTerminal(const LiveTerminal&) = delete;
  LiveTerminal& operator=(const LiveTerminal&) = delete;

  /// Draws `lines` from the top; what does not fit is cut.
  void draw(const std::vector<std::string>& lines);
  /// Waits for keys, up to `timeout`: what was typed, as the terminal sends it. None once the terminal is gone.
  [[nodiscard]] std::optional<std::string> keys(Duration timeout);

 private:
  termios before_{};
};

/// `text` without anything that moves a terminal's cursor: names come from strangers.
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace tandem::cli
