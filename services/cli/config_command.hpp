#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem config check`, `tandem config show`.
void add_config_command(CLI::App& tandem);

}  // namespace tandem::cli
