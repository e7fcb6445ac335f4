#pragma once

#include <string>
#include <vector>

namespace tandem {

/// One line of a CSV file (RFC 4180, lines end with a line feed).
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace tandem
