#pragma once

#include <string>
#include <vector>

#include "bench/network/record.hpp"

/// Figures of many measurements, for tables and targets.
namespace tandem::bench {

using Records = std::vector<NetworkRecord>;

/// One figure over all runs of a measurement.
[[nodiscard]] std::vector<double> values_of(const Records& records, const std::string& what, const std::string& whose,
                                            const std::string& air, const std::string& figure);

[[nodiscard]] std::string text_of_number(double value);
/// "median (lowest to highest)".
[[nodiscard]] std::string text_of_values(const std::vector<double>& values);

/// How false stops add up over all runs.
struct FalseStopSum {
  double stops = 0.0;
  double driven_h = 0.0;
};
[[nodiscard]] FalseStopSum false_stop_sum(const Records& records);

}  // namespace tandem::bench
