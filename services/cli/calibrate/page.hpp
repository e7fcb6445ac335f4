#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tandem::cli {

/// A whole HTML page in the style of the calibration reports; `body` is HTML.
[[nodiscard]] std::string html_page(std::string_view title, const std::string& body);
[[nodiscard]] std::string escaped_html(std::string_view words);
/// A row of a table; `cell` is "td" or "th", the words are escaped.
[[nodiscard]] std::string table_row(const std::vector<std::string>& words, std::string_view cell);
[[nodiscard]] std::string page_number(double value, int decimals);

}  // namespace tandem::cli
