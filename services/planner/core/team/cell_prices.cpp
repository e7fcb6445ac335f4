#include "services/planner/core/team/cell_prices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

constexpr int kPasses = 3;
constexpr double kAheadCells = 1.5;  ///< so many search cells a leg may be ahead at first sight: measured best
constexpr int kSamples = 8;          ///< of a leg, to see how far it is ahead at a finite rate
constexpr double kRounding = 1e-6;   ///< relative, of single precision

/// How far a leg may be ahead of its budget, in seconds of the team's time.
double allowed_ahead_s(const LegTable::Capability& capability, double cell_size_m) {
  if (!std::isinf(capability.rate_per_s)) return std::numeric_limits<double>::infinity();
  return kAheadCells * capability.share * cell_size_m / capability.speed_mps;
}

/// Divides each price by the highest load of a leg, or of a beginning of one, that shows the cell. All loads are at most
/// 1 then, as each cell of a leg was divided by that leg's load or more.
void balance(const LegTable& table, const std::vector<double>& ahead_s, std::vector<double>& price_s) {
  std::vector<double> highest(price_s.size(), 0.0);
  for (const LegTable::Row& row : table.rows) {
    double shown_s = 0.0;
    for (std::size_t i = row.begin; i < row.end; ++i) {
      shown_s += table.detected[i] * price_s[static_cast<std::size_t>(table.cells[i])];
    }
    double load = shown_s / row.budget_s;
    const double allowed_s = ahead_s[row.capability];
    for (std::size_t i = row.end; i-- > row.begin;) {
      const auto cell = static_cast<std::size_t>(table.cells[i]);
      load = std::max(load, shown_s / (table.time_s[i] + allowed_s));
      shown_s -= table.detected[i] * price_s[cell];
      highest[cell] = std::max(highest[cell], load);
    }
  }
  for (std::size_t cell = 0; cell < price_s.size(); ++cell) {
    if (highest[cell] > 0.0) price_s[cell] /= highest[cell];
  }
}

/// The most by which a leg shows more than its budget until then.
double ahead_of_leg_s(const LegTable& table, const LegTable::Row& row, const std::vector<double>& price_s) {
  const LegTable::Capability& capability = table.capabilities[row.capability];
  double ahead_s = 0.0;
  if (std::isinf(capability.rate_per_s)) {
    double shown_s = 0.0;
    for (std::size_t i = row.begin; i < row.end; ++i) {
      shown_s += table.detected[i] * price_s[static_cast<std::size_t>(table.cells[i])];
      ahead_s = std::max(ahead_s, shown_s - table.time_s[i]);
    }
    return ahead_s;
  }
  for (int sample = 1; sample <= kSamples; ++sample) {
    const double until_s = row.budget_s * sample / kSamples;
    double shown_s = 0.0;
    for (std::size_t i = row.begin; i < row.end && table.time_s[i] <= until_s; ++i) {
      const double looked_s = (until_s - table.time_s[i]) / capability.share;
      const double detected = std::min<double>(table.detected[i], capability.rate_per_s * looked_s);
      shown_s += detected * price_s[static_cast<std::size_t>(table.cells[i])];
    }
    ahead_s = std::max(ahead_s, shown_s - row.budget_s * (sample - 1) / kSamples);
  }
  return ahead_s;
}

}  // namespace

CellPrices cell_prices(const PreparedProblem& problem, const LegTable& table, const std::vector<double>& mass) {
  std::vector<double> allowed_s;
  for (const LegTable::Capability& capability : table.capabilities) {
    allowed_s.push_back(allowed_ahead_s(capability, problem.problem().world->area().cell_size_m()));
  }
  CellPrices prices;
  prices.price_s = mass;
  for (std::size_t cell = 0; cell < mass.size(); ++cell) {
    if (table.is_free[cell] || std::isinf(table.in_view_s[cell])) prices.price_s[cell] = 0.0;
  }
  for (int pass = 0; pass < kPasses; ++pass) balance(table, allowed_s, prices.price_s);
  for (double& price_s : prices.price_s) price_s *= 1.0 - kRounding;

  std::vector<double> ahead_s(table.capabilities.size(), 0.0);
  for (const LegTable::Row& row : table.rows) {
    if (std::isinf(row.begin_s)) continue;  // what turning shows grows with its time
    ahead_s[row.capability] = std::max(ahead_s[row.capability], ahead_of_leg_s(table, row, prices.price_s));
  }
  prices.members.resize(problem.members().size());
  for (std::size_t i = 0; i < table.capabilities.size(); ++i) {
    const LegTable::Capability& capability = table.capabilities[i];
    for (const std::size_t m : capability.members) {
      prices.members[m] = {capability.share, std::max(capability.first_s, problem.members()[m].start_s),
                           ahead_s[i] * (1.0 + kRounding) + kRounding};
    }
  }
  return prices;
}

}  // namespace tandem
