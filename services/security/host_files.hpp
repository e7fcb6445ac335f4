#pragma once

#include <filesystem>

#include "services/common/security_files.hpp"
#include "services/security/documents.hpp"

/// The folder in which a lab keeps its authority, and those that go to its hosts:
///
///     authority.crt  authority.key  governance.p7s  hosts/robot1/...
namespace tandem::security {

/// Makes an authority and the governance in `folder`. Throws std::runtime_error if there is one already: a new one
/// would lock out every host.
void make_authority(const std::filesystem::path& folder, const Validity& validity);

/// Makes what `host` needs, with the authority of `folder`, in hosts/`host` of it, and gives that folder. What was
/// there is replaced. `permissions.subject` is not asked. Throws std::runtime_error.
std::filesystem::path make_host_files(const std::filesystem::path& folder, const std::string& host,
                                      Permissions permissions);

}  // namespace tandem::security
