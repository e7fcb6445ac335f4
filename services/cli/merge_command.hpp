#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {
void add_merge_command(CLI::App& tandem);
}  // namespace tandem::cli
