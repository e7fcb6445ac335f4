#include "services/cli/up/config_text.hpp"

#include <sstream>

namespace tandem::cli {
namespace {

bool sets(std::string_view line, std::string_view key) {
  const auto start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || line.substr(start, key.size()) != key) return false;
  const auto next = line.find_first_not_of(" \t", start + key.size());
  return next != std::string_view::npos && line[next] == '=';
}

}  // namespace

std::string with_value(const std::string& toml, std::string_view key, std::string_view value) {
  const std::string setting = std::string{key} + " = " + std::string{value};
  std::istringstream lines{toml};
  std::string result;
  bool replaced = false;
  for (std::string line; std::getline(lines, line);) {
    const bool matches = !replaced && sets(line, key);
    result += (matches ? setting : line) + "\n";
    replaced = replaced || matches;
  }
  return replaced ? result : result + setting + "\n";
}

std::string toml_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace tandem::cli
