#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem track`.
void add_track_command(CLI::App& tandem);

}  // namespace tandem::cli
