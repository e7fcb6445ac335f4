#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {
void add_recover_command(CLI::App& tandem);
}  // namespace tandem::cli
