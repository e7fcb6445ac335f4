#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem stop`, `tandem resume`.
void add_stop_commands(CLI::App& tandem);

}  // namespace tandem::cli
