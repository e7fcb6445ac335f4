#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tandem::bench {

/// `first`: the first plans of planners, and how they get better with time: what a planner's options are tuned with.
/// Sets `chosen` to what is to be done if the command is given.
void add_first_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace tandem::bench
