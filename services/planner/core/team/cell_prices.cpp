#include "services/planner/core/team/cell_prices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

constexpr int kPasses = 3;
constexpr int kSamples = 8;         ///< of a leg, to see how far it is ahead at a finite rate
constexpr double kRounding = 1e-6;  ///< relative, of single precision
// Of first sight, measured best on the S1 families:
constexpr double kAheadOfView = 0.125;    ///< how far a leg may be ahead, in ranges of view and a search cell
constexpr double kPieceAheadOfLeg = 0.2;  ///< how far an unfinished piece may be ahead, as a share of that

/// What the members of one capability may be ahead, in seconds of the team's time.
struct Allowance {
  double leg_s = std::numeric_limits<double>::infinity();
  double piece_s = 0.0;
  double piece_length_s = 0.0;  ///< 0: each leg is a piece
};

/// At a finite rate what a leg detects cannot be added up over a piece, so its pieces are the legs.
Allowance allowance_of(const LegTable::Capability& capability, double cell_size_m) {
  Allowance allowance;
  if (!std::isinf(capability.rate_per_s)) return allowance;
  const double team_s_per_m = capability.share / capability.speed_mps;
  allowance.leg_s = team_s_per_m * (cell_size_m + kAheadOfView * capability.view_max_m);
  allowance.piece_s = kPieceAheadOfLeg * allowance.leg_s;
  allowance.piece_length_s = team_s_per_m * kPieceOfViews * capability.view_max_m;
  return allowance;
}

/// Divides each price by the highest load of a leg, or of a beginning of one, that shows the cell. All loads are at
/// most 1 then, as each cell of a leg was divided by that leg's load or more. A leg shorter than a piece may be ahead.
void balance(const LegTable& table, const std::vector<Allowance>& allowances, std::vector<double>& price_s) {
  std::vector<double> highest(price_s.size(), 0.0);
  for (const LegTable::Row& row : table.rows) {
    const Allowance& allowance = allowances[row.capability];
    double shown_s = 0.0;
    for (std::size_t i = row.begin; i < row.end; ++i) {
      shown_s += table.detected[i] * price_s[static_cast<std::size_t>(table.cells[i])];
    }
    double load = shown_s / (row.budget_s + (row.budget_s < allowance.piece_length_s ? allowance.piece_s : 0.0));
    for (std::size_t i = row.end; i-- > row.begin;) {
      const auto cell = static_cast<std::size_t>(table.cells[i]);
      load = std::max(load, shown_s / (table.time_s[i] + allowance.leg_s));
      shown_s -= table.detected[i] * price_s[cell];
      highest[cell] = std::max(highest[cell], load);
    }
  }
  for (std::size_t cell = 0; cell < price_s.size(); ++cell) {
    if (highest[cell] > 0.0) price_s[cell] /= highest[cell];
  }
}

/// Lowers prices until no piece of a walk shows more than it may. A piece ends when it is long enough or has the most
/// legs; as any walk is cut into such pieces, their sums are what counts, and a cell counts once in a piece.
class PieceCut {
 public:
  PieceCut(const LegTable& table, std::size_t capability, const Allowance& allowance, std::vector<double>& price_s)
      : table_(table),
        allowance_(allowance),
        price_s_(price_s),
        highest_(price_s.size(), 1.0),
        in_piece_(price_s.size(), false) {
    for (const LegTable::Row& row : table.rows) {
      if (row.capability != capability) continue;
      double shown_s = 0.0;
      for (std::size_t i = row.begin; i < row.end; ++i) shown_s += price_s[static_cast<std::size_t>(table.cells[i])];
      const auto places = static_cast<std::size_t>(std::max(row.from, row.to)) + 1;
      if (legs_.size() < places) legs_.resize(places);
      legs_[static_cast<std::size_t>(row.from)].push_back({&row, shown_s - row.budget_s});
    }
    most_ahead_s_.assign(kMostLegsOfPiece, std::vector<double>(legs_.size(), 0.0));
    for (std::size_t legs = 1; legs < kMostLegsOfPiece; ++legs) {
      for (std::size_t place = 0; place < legs_.size(); ++place) {
        for (const Leg& leg : legs_[place]) {
          double& most_s = most_ahead_s_[legs][place];
          most_s = std::max(most_s, leg.ahead_s + most_ahead_s_[legs - 1][static_cast<std::size_t>(leg.row->to)]);
        }
      }
    }
  }

  void cut() {
    for (std::size_t place = 0; place < legs_.size(); ++place) go_on(place, kMostLegsOfPiece, 0.0, 0.0);
    for (std::size_t cell = 0; cell < price_s_.size(); ++cell) price_s_[cell] /= highest_[cell];
  }

 private:
  struct Leg {
    const LegTable::Row* row;
    double ahead_s;
  };

  /// Goes on from `place` with at most so many legs, where it can still come to be ahead.
  void go_on(std::size_t place, std::size_t legs_left, double shown_s, double budget_s) {
    for (const Leg& leg : legs_[place]) {
      const auto to = static_cast<std::size_t>(leg.row->to);
      const double piece_s = budget_s + leg.row->budget_s;
      const bool ends = piece_s >= allowance_.piece_length_s || legs_left == 1;
      const double most_ahead_s = shown_s - budget_s + leg.ahead_s + (ends ? 0.0 : most_ahead_s_[legs_left - 1][to]);
      if (most_ahead_s <= 0.0) continue;
      const std::size_t before = cells_.size();
      double all_s = shown_s;
      for (std::size_t i = leg.row->begin; i < leg.row->end; ++i) {
        const auto cell = static_cast<std::size_t>(table_.cells[i]);
        if (in_piece_[cell]) continue;
        in_piece_[cell] = true;
        cells_.push_back(cell);
        all_s += price_s_[cell];
      }
      const double load = all_s / (piece_s + (ends ? 0.0 : allowance_.piece_s));
      if (load > 1.0) {
        for (const std::size_t cell : cells_) highest_[cell] = std::max(highest_[cell], load);
      }
      if (!ends) go_on(to, legs_left - 1, all_s, piece_s);
      for (; cells_.size() > before; cells_.pop_back()) in_piece_[cells_.back()] = false;
    }
  }

  const LegTable& table_;
  const Allowance& allowance_;
  std::vector<double>& price_s_;
  std::vector<std::vector<Leg>> legs_;             ///< per place
  std::vector<std::vector<double>> most_ahead_s_;  ///< by how many legs are left, then place
  std::vector<double> highest_;
  std::vector<bool> in_piece_;
  std::vector<std::size_t> cells_;  ///< of the piece
};

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
  std::vector<Allowance> allowances;
  for (const LegTable::Capability& capability : table.capabilities) {
    allowances.push_back(allowance_of(capability, problem.problem().world->area().cell_size_m()));
  }
  CellPrices prices;
  prices.price_s = mass;
  for (std::size_t cell = 0; cell < mass.size(); ++cell) {
    if (table.is_free[cell] || std::isinf(table.in_view_s[cell])) prices.price_s[cell] = 0.0;
  }
  for (int pass = 0; pass < kPasses; ++pass) balance(table, allowances, prices.price_s);
  for (std::size_t i = 0; i < allowances.size(); ++i) {
    if (allowances[i].piece_length_s > 0.0) PieceCut(table, i, allowances[i], prices.price_s).cut();
  }
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
                           (allowances[i].piece_s + ahead_s[i]) * (1.0 + kRounding) + kRounding};
    }
  }
  return prices;
}

}  // namespace tandem
