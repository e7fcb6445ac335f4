#pragma once

#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

/// How a command of the `tandem` program is made:
///
///  1. services/cli/<name>_command.hpp declares `void add_<name>_command(CLI::App& tandem);`
///  2. services/cli/<name>_command.cpp defines it: a struct of options, `add_command(...)`, its options bound to a
///     shared_ptr of that struct, and `->callback([options] { run(*options); })`. run() returns when all went well and
///     throws otherwise: WrongUse (exit 2) or anything else derived from std::exception (exit 1, what() is printed).
///  3. one line in main.cpp, one in CMakeLists.txt.
///
/// Results go to standard output (JSON with --json), all else to standard error. A file appears whole or not at all:
/// write NAME.part, rename at the end. Loops ask stop_requested() and then throw Interrupted. See info_command.cpp.
namespace tandem::cli {

/// The command line asks for what cannot be meant: exit code 2.
class WrongUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The command did its work and the answer is no (damage was found, no object was found): exit code 1, nothing printed.
class Failed : public std::exception {};

/// As Failed, with an exit code that tells how bad it is.
class Sick : public std::exception {
 public:
  explicit Sick(int exit_code) : exit_code_(exit_code) {}
  [[nodiscard]] int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

/// Ctrl-C: exit code 130, after everything half-written is gone.
class Interrupted : public std::exception {};

/// A subcommand of `tandem` with its help text; `example` stands at the end of it.
[[nodiscard]] CLI::App* add_command(CLI::App& tandem, const std::string& name, const std::string& purpose,
                                    const std::string& example);

/// True once Ctrl-C or SIGTERM came. Before the first call they simply end the process; a command that writes files
/// calls it first thing, and then asks in every loop.
[[nodiscard]] bool stop_requested();

}  // namespace tandem::cli
