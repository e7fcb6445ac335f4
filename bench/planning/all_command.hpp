#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tandem::bench {

/// `all`: everything a report needs, then the report. Sets `chosen` to what is to be done if the command is given.
void add_all_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace tandem::bench
