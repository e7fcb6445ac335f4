#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem map build`, `tandem map check`.
void add_map_command(CLI::App& tandem);

}  // namespace tandem::cli
