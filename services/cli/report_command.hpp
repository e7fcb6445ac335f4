#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// Adds `tandem report`.
void add_report_command(CLI::App& tandem);

}  // namespace tandem::cli
