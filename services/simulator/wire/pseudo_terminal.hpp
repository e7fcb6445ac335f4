#pragma once

#include <filesystem>
#include <string>

#include "services/simulator/wire/connection.hpp"

namespace tandem::simulator {

/// A serial port that is none: clients open its path like /dev/ttyUSB0.
class PseudoTerminal {
 public:
  /// Also makes `link` point to it, in place of an older link. Throws std::runtime_error, naming path and remedy, which
  /// is at `config_key`, "base_pty".
  PseudoTerminal(const std::filesystem::path& link, const std::string& config_key);
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  /// Takes the link away.
  ~PseudoTerminal();

  /// Our end of it; the other end may be opened and closed at will.
  [[nodiscard]] Connection& connection() { return connection_; }
  [[nodiscard]] int descriptor() const { return connection_.descriptor(); }
  /// The rate that the client has set [baud].
  [[nodiscard]] int line_rate() const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::filesystem::path link_;
  Connection connection_;
  int client_end_ = -1;  ///< Held open, so that a client that leaves is no hang-up.
  std::string path_;
};

}  // namespace tandem::simulator
