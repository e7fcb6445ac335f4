#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem secure init`, `tandem secure add`, `tandem secure check`.
void add_secure_command(CLI::App& tandem);

}  // namespace tandem::cli
