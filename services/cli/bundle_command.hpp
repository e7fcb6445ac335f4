#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem bundle`.
void add_bundle_command(CLI::App& tandem);

}  // namespace tandem::cli
