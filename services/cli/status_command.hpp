#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// Adds `tandem status`.
void add_status_command(CLI::App& tandem);

}  // namespace tandem::cli
