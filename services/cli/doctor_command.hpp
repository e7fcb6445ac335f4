#pragma once

namespace CLI {
class App;
}

namespace tandem::cli {

/// `tandem doctor`.
void add_doctor_command(CLI::App& tandem);

}  // namespace tandem::cli
