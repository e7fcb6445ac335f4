#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tandem::bench {

/// `scores`: how planners do on the frozen scenarios, beside the scores that are kept there. Sets `chosen` to what is
/// to be done if the command is given.
void add_scores_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace tandem::bench
