#pragma once

#include <string>

namespace tandem {

/// The text that printf would print, however long: for tables, reports and pictures.
///
/// The compiler checks `format` against the values; numbers have a decimal point as long as nobody sets the process's
/// locale, and no program of ours does.
[[nodiscard, gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace tandem
