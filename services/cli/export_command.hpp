#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {
void add_export_command(CLI::App& tandem);
}  // namespace tandem::cli
