#include "services/security/host_files.hpp"

#include <stdexcept>

#include "services/common/file_io.hpp"

namespace tandem::security {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder " + folder.string() + ": " + error.message());
}

Identity authority_in(const fs::path& folder) {
  if (!fs::exists(folder / "authority.key")) {
    throw std::runtime_error(folder.string() + ": no authority here (authority.key). Make one: tandem secure init");
  }
  return {read_file(folder / "authority.crt"), read_file(folder / "authority.key")};
}

}  // namespace

void make_authority(const fs::path& folder, const Validity& validity) {
  if (fs::exists(folder / "authority.key")) {
    throw std::runtime_error(folder.string() +
                             ": there is an authority already. A new one locks out every host that has files of it; "
                             "name another --folder");
  }
  make_folder(folder);
  const Identity authority = new_authority(validity);
  write_private_file(folder / "authority.key", authority.key_pem);
  write_file_atomically(folder / "authority.crt", authority.certificate_pem);
  write_file_atomically(folder / "governance.p7s", signed_document(authority, governance_xml()));
}

fs::path make_host_files(const fs::path& folder, const std::string& host, Permissions permissions) {
  const Identity authority = authority_in(folder);
  const Identity identity = new_host_identity(authority, host, permissions.validity);
  permissions.subject = subject_of(identity.certificate_pem);
  const fs::path made = folder / "hosts" / host;
  make_folder(made);
  const SecurityFiles files = security_files_in(made);
  write_private_file(files.key, identity.key_pem);
  write_file_atomically(files.certificate, identity.certificate_pem);
  write_file_atomically(files.authority, authority.certificate_pem);
  write_file_atomically(files.governance, read_file(folder / "governance.p7s"));
  write_file_atomically(files.permissions, signed_document(authority, permissions_xml(permissions)));
  return made;
}

}  // namespace tandem::security
