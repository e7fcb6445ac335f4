#include "services/localization/core/number_lines.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tandem {
namespace {

/// The finite numbers in `line`; none if there is anything else in it.
std::optional<std::vector<double>> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
    if (at == end) return numbers;
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    at = next;
  }
}

}  // namespace

std::vector<std::vector<double>> number_lines(const std::string& text, std::size_t count,
                                              const std::string& file_name) {
  std::vector<std::vector<double>> lines;
  std::istringstream stream{text};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with('#')) continue;
    auto numbers = numbers_in(line);
    if (numbers && numbers->empty()) continue;
    if (!numbers || numbers->size() < count) {
      throw std::runtime_error{file_name + ":" + std::to_string(number) + ": expected " + std::to_string(count) +
                               " numbers"};
    }
    lines.push_back(std::move(*numbers));
  }
  return lines;
}

}  // namespace tandem
