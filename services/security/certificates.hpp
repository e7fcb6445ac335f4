#pragma once

#include <optional>
#include <string>

#include "services/common/time.hpp"

/// Certificates and signed documents of a secured link (DDS Security). See docs/security.md.
namespace tandem::security {

/// A certificate with its private key, both PEM.
struct Identity {
  std::string certificate_pem;
  std::string key_pem;
};

/// The closed span in which something holds.
struct Validity {
  Time begins{};
  Time ends{};
};

/// A new authority: its key signs the hosts' certificates and what they may do. Its name tells it from any other.
[[nodiscard]] Identity new_authority(const Validity& validity);

/// A new certificate for `host`, with that as its name, signed by `authority`.
[[nodiscard]] Identity new_host_identity(const Identity& authority, const std::string& host, const Validity& validity);

/// The subject of a certificate as DDS Security wants it in permissions (RFC 2253): "CN=robot1".
[[nodiscard]] std::string subject_of(const std::string& certificate_pem);

/// `text`, signed by `authority` as S/MIME, readable.
[[nodiscard]] std::string signed_document(const Identity& authority, const std::string& text);

/// What was signed; nothing if `document` is no signed one, or not signed by the authority with that certificate. At
/// which time does not matter.
[[nodiscard]] std::optional<std::string> verified_document(const std::string& document,
                                                           const std::string& authority_pem);

}  // namespace tandem::security
