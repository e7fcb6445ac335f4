#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tandem::bench {

/// `run`: searches with planners in the loop, a line for each, and how the planners compare. Sets `chosen` to what is
/// to be done if the command is given.
void add_run_command(CLI::App& app, std::function<int()>& chosen);

/// `freeze`: writes instances as planning scenarios.
void add_freeze_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace tandem::bench
