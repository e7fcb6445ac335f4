#include "services/cli/command.hpp"

#include <CLI/CLI.hpp>

#include "services/common/stop_signal.hpp"

namespace tandem::cli {

CLI::App* add_command(CLI::App& tandem, const std::string& name, const std::string& purpose,
                      const std::string& example) {
  CLI::App* command = tandem.add_subcommand(name, purpose);
  command->footer("Example: " + example);
  return command;
}

bool stop_requested() {
  static const StopSignal stop;
  return stop.requested();
}

}  // namespace tandem::cli
