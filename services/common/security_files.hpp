#pragma once

#include <filesystem>

namespace tandem {

/// What a host on a secured link keeps, in one folder. `tandem secure add` makes it; docs/security.md says what is
/// what.
struct SecurityFiles {
  std::filesystem::path authority;    ///< certificate of the lab's authority, the same on all hosts
  std::filesystem::path certificate;  ///< of this host
  std::filesystem::path key;          ///< of that certificate: nobody else may read it
  std::filesystem::path governance;   ///< how the link is protected, signed by the authority
  std::filesystem::path permissions;  ///< which topics this host may write and read, signed by the authority
};

[[nodiscard]] inline SecurityFiles security_files_in(const std::filesystem::path& folder) {
  return {folder / "authority.crt", folder / "host.crt", folder / "host.key", folder / "governance.p7s",
          folder / "permissions.p7s"};
}

}  // namespace tandem
