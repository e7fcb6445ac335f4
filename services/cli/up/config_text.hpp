#pragma once

#include <string>
#include <string_view>

namespace tandem::cli {

/// `toml` with `key` set to the TOML value `value` (quoted already): its line replaced, or one added at the end.
///
/// For flat files like ours; comments and all other lines stay as they are.
[[nodiscard]] std::string with_value(const std::string& toml, std::string_view key, std::string_view value);

/// `text` as a TOML string.
[[nodiscard]] std::string toml_string(const std::string& text);

}  // namespace tandem::cli
