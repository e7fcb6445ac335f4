#pragma once

#include <string>
#include <string_view>

namespace tandem {

/// SHA-256 of `bytes` as 64 hex digits.
[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace tandem
