#include "bench/network/figures.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "bench/planning/statistics/statistics.hpp"

namespace tandem::bench {

std::vector<double> values_of(const Records& records, const std::string& what, const std::string& whose,
                              const std::string& air, const std::string& figure) {
  std::vector<double> values;
  for (const auto& record : records) {
    const auto& key = record.key;
    if (key.what != what || key.whose != whose || key.air != air) continue;
    const auto found = record.figures.find(figure);
    if (found != record.figures.end()) values.push_back(found->second);
  }
  return values;
}

std::string text_of_number(double value) {
  if (value >= kNever) return "never";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(),
                value >= 100.0 || value == 0.0 ? "%.0f"
                : value >= 1.0                 ? "%.1f"
                                               : "%.3f",
                value);
  return text.data();
}

std::string text_of_values(const std::vector<double>& values) {
  if (values.empty()) return "–";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string median = text_of_number(quantile(values, 0.5));
  if (values.size() == 1 || *low == *high) return median;
  return median + " (" + text_of_number(*low) + " to " + text_of_number(*high) + ")";
}

FalseStopSum false_stop_sum(const Records& records) {
  FalseStopSum sum;
  for (const auto& record : records) {
    if (record.key.what != "false_stops" || record.figures.empty()) continue;
    sum.stops += record.figures.at("false_stops") + record.figures.at("without_plan");
    sum.driven_h += record.figures.at("driven_h");
  }
  return sum;
}

}  // namespace tandem::bench
