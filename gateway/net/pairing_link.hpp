#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tandem::net {

/// What a QR code tells a phone: `https://host:port/p#t=TOKEN&fp=FINGERPRINT`.
///
/// The token stands in the fragment, so it reaches neither a server's log nor a Referer header.
struct PairingLink {
  std::string host;
  std::uint16_t port = 0;
  std::string token;
  std::string fingerprint;  ///< first 16 hex digits of the certificate's SHA-256

  friend bool operator==(const PairingLink&, const PairingLink&) = default;
};

/// None when `text` (white space around it is allowed) is not such a link.
[[nodiscard]] std::optional<PairingLink> parse_pairing_link(std::string_view text);

[[nodiscard]] std::string to_string(const PairingLink& link);

}  // namespace tandem::net
