#pragma once

#include <string>

namespace tandem {

/// "0.1.0", the release.
[[nodiscard]] std::string version();
/// The commit it was built from, empty outside a repository.
[[nodiscard]] std::string commit();
/// First 16 hex digits of the SHA-256 over all IDL files: equal hash, equal wire format.
[[nodiscard]] std::string contract_hash();
/// What `--version` prints after the program's name.
[[nodiscard]] std::string version_line();

}  // namespace tandem
