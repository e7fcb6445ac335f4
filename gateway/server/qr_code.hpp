#pragma once

#include <string>

namespace tandem::gateway {

/// `text` as a QR code in UTF-8 half blocks, dark on light, with its quiet zone; empty if it is too long for one.
[[nodiscard]] std::string qr_code(const std::string& text);

}  // namespace tandem::gateway
