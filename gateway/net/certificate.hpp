#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tandem::net {

/// A TLS certificate with its private key.
struct Certificate {
  std::string certificate_pem;
  std::string private_key_pem;
  std::string fingerprint;  ///< first 16 hex digits of the SHA-256 of the certificate
};

/// The certificate kept in `folder` (gateway.crt, gateway.key), or a new self-signed P-256 one for `names` (host names
/// and IP addresses), valid 397 days, when there is none, it has expired, or it does not name all of them.
///
/// The key file is readable by its owner alone. Throws std::runtime_error when the folder cannot be used.
[[nodiscard]] Certificate load_or_create_certificate(const std::filesystem::path& folder,
                                                     const std::vector<std::string>& names);

/// `count` random bytes from the operating system, as lower-case hex. For tokens and session ids.
[[nodiscard]] std::string random_hex(std::size_t count);

/// SHA-256 of `text` as lower-case hex.
[[nodiscard]] std::string sha256_hex(const std::string& text);

}  // namespace tandem::net
