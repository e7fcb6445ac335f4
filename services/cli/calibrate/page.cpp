#include "services/cli/calibrate/page.hpp"

#include <cstdio>

#include "services/cli/plan/svg.hpp"

namespace tandem::cli {
namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:860px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse}td,th{padding:.25em 1em .25em 0;text-align:left;border-bottom:1px solid #ddd}"
    "td+td,th+th{text-align:right;font-variant-numeric:tabular-nums}"
    "svg{max-width:100%;height:auto}"
    ".good{background:#e6f4e6;padding:.6em 1em}.bad{background:#fbe6e3;padding:.6em 1em}";

}  // namespace

std::string html_page(std::string_view title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped_html(title) +
         "</title>\n<meta name=\"viewport\" content=\"width=device-width\"><style>" + kStyle +
         "</style></head>\n<body>\n" + body + "</body></html>\n";
}

std::string escaped_html(std::string_view words) {
  return svg_escaped(words);
}

std::string table_row(const std::vector<std::string>& words, std::string_view cell) {
  const std::string tag{cell};
  std::string row = "<tr>";
  for (const std::string& word : words) row += "<" + tag + ">" + escaped_html(word) + "</" + tag + ">";
  return row + "</tr>\n";
}

std::string page_number(double value, int decimals) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
  return digits;
}

}  // namespace tandem::cli
