#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// Adds `tandem session start|end|list|delete`.
void add_session_command(CLI::App& tandem);

}  // namespace tandem::cli
