#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tandem::cli {

/// `bytes` as base64 (RFC 4648, padded).
[[nodiscard]] std::string base64_of(std::span<const std::uint8_t> bytes);

}  // namespace tandem::cli
