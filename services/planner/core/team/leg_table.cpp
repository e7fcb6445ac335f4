#include "services/planner/core/team/leg_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastBudget_s = 1e-9;
constexpr double kBorder = 1e-4;  ///< so near to the border of a search cell a place is on it [cells]

bool is_on_border(const SearchArea& area, const Eigen::Vector2d& point_in_map) {
  const Eigen::Array2d cells = ((point_in_map - area.origin_in_map()) / area.cell_size_m()).array();
  return ((cells - cells.round()).abs() < kBorder).any();
}

class Builder {
 public:
  Builder(const PreparedProblem& problem, const std::vector<NearLegs>& near, const std::vector<double>& mass)
      : world_(*problem.problem().world),
        members_(problem.members()),
        near_(near),
        mass_(mass),
        row_of_(mass.size(), 0),
        entry_of_(mass.size(), 0) {
    table_.in_view_s.assign(mass.size(), kInfinity);
    table_.is_free.assign(mass.size(), false);
  }

  LegTable table() {
    add_capabilities();
    make_room();
    for (std::size_t i = 0; i < near_.size(); ++i) free_starts(i);
    for (std::size_t i = 0; i < near_.size(); ++i) add_rows(i);
    trim_first_legs();
    return std::move(table_);
  }

 private:
  [[nodiscard]] const Searcher& searcher(std::size_t capability) const { return near_[capability].actions->searcher(); }
  [[nodiscard]] bool finds_at_once(std::size_t capability) const {
    return std::isinf(searcher(capability).detection_rate_per_s);
  }

  void add_capabilities() {
    double total = 0.0;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const double share = searcher(i).speed_mps * searcher(i).view_max_m;
      table_.capabilities.push_back({share, searcher(i).speed_mps, searcher(i).view_max_m,
                                     searcher(i).detection_rate_per_s, kInfinity, near_[i].members});
      total += share * static_cast<double>(near_[i].members.size());
    }
    for (LegTable::Capability& capability : table_.capabilities) capability.share /= total;
  }

  void make_room() {
    std::size_t sightings = 0;
    for (const NearLegs& near : near_) {
      for (const NearLegs::Entry& entry : near.legs) sightings += entry.leg->seen.size();
    }
    table_.cells.reserve(sightings);
    table_.detected.reserve(sightings);
    table_.time_s.reserve(sightings);
  }

  void free_starts(std::size_t capability) {
    if (!finds_at_once(capability)) return;
    for (const std::size_t m : near_[capability].members) {
      const PreparedProblem::Member& who = members_[m];
      const auto set_free = [&](std::int32_t cell) {
        bring_into_view(static_cast<std::size_t>(cell), who.start_s);
        table_.is_free[static_cast<std::size_t>(cell)] = true;
      };
      std::ranges::for_each(who.stay->cells, set_free);
      for (const NearLegs::Entry& entry : near_[capability].legs) {
        const Sightings& seen = entry.leg->seen;
        if (entry.from != who.start) continue;
        for (std::size_t i = 0; i < seen.size() && seen.enter_s[i] <= 0.0; ++i) set_free(seen.cells[i]);
      }
    }
  }

  void add_rows(std::size_t capability) {
    const bool turns = !searcher(capability).sees_all_around();
    const bool finds = finds_at_once(capability);
    const double rate_per_s = searcher(capability).detection_rate_per_s;
    if (turns && !finds) {
      for (const std::size_t m : near_[capability].members) {
        add_turn(capability, *members_[m].stay, members_[m].start_s);
      }
    }
    for (const NearLegs::Entry& entry : near_[capability].legs) {
      const Leg& leg = *entry.leg;
      const double begin_s = near_[capability].earliest_s[static_cast<std::size_t>(entry.from)];
      begin_row(capability, leg.duration_s, begin_s, entry.from, entry.to);
      std::size_t i = 0;
      if (is_found_on_arrival(capability, entry.from)) {
        for (; i < leg.seen.size() && leg.seen.enter_s[i] <= 0.0; ++i) leave_out(leg.seen.cells[i]);
      }
      for (; i < leg.seen.size(); ++i) {
        const double stay_s = leg.seen.leave_s[i] - leg.seen.enter_s[i];
        add(leg.seen.cells[i], finds ? 1.0 : -std::expm1(-rate_per_s * stay_s), leg.seen.enter_s[i], begin_s);
      }
      if (turns && finds) {
        for (const std::int32_t cell : leg.stay.cells) add(cell, 1.0, leg.duration_s, begin_s);
      }
      end_row();
      if (turns && !finds) add_turn(capability, leg.stay, begin_s + leg.duration_s);
    }
  }

  /// Whether who sets out from `place` has found what is in view there. On a border of search cells the view on arrival
  /// is that of the cell one comes from.
  [[nodiscard]] bool is_found_on_arrival(std::size_t capability, int place) const {
    return finds_at_once(capability) && searcher(capability).sees_all_around() &&
           !is_on_border(world_.area(), near_[capability].actions->place(place));
  }

  /// A second of turning; detection is at most its rate times the time.
  void add_turn(std::size_t capability, const Sightings& view, double earliest_s) {
    begin_row(capability, 1.0, kInfinity, -1, -1);
    for (const std::int32_t cell : view.cells) add(cell, searcher(capability).detection_rate_per_s, 0.0, earliest_s);
    end_row();
  }

  void begin_row(std::size_t capability, double duration_s, double begin_s, int from, int to) {
    share_ = table_.capabilities[capability].share;
    const double budget_s = std::max(kLeastBudget_s, share_ * duration_s);
    table_.rows.push_back({budget_s, begin_s, table_.cells.size(), 0, capability, from, to});
    ++row_;
  }

  void leave_out(std::int32_t cell) {
    row_of_[static_cast<std::size_t>(cell)] = row_;
    entry_of_[static_cast<std::size_t>(cell)] = kLeftOut;
  }

  void add(std::int32_t cell, double detected, double after_s, double begin_s) {
    const auto c = static_cast<std::size_t>(cell);
    if (row_of_[c] != row_) {
      if (mass_[c] <= 0.0) return leave_out(cell);
      bring_into_view(c, begin_s + after_s);
      if (table_.is_free[c]) return leave_out(cell);
      row_of_[c] = row_;
      entry_of_[c] = table_.cells.size();
      if (entry_of_[c] == table_.rows.back().begin) {
        double& first_s = table_.capabilities[table_.rows.back().capability].first_s;
        first_s = std::min(first_s, begin_s + after_s);
      }
      table_.cells.push_back(cell);
      table_.detected.push_back(static_cast<float>(detected));
      table_.time_s.push_back(static_cast<float>(share_ * after_s));
    } else if (entry_of_[c] != kLeftOut && detected < 1.0) {
      float& before = table_.detected[entry_of_[c]];
      before = static_cast<float>(1.0 - (1.0 - before) * (1.0 - detected));
    }
  }

  void end_row() { table_.rows.back().end = table_.cells.size(); }

  void bring_into_view(std::size_t cell, double time_s) {
    table_.in_view_s[cell] = std::min(table_.in_view_s[cell], time_s);
  }

  /// Until `first_s` nobody finds anything, so the leg under way then shows what it shows in what is left of it.
  void trim_first_legs() {
    for (LegTable::Row& row : table_.rows) {
      const LegTable::Capability& capability = table_.capabilities[row.capability];
      if (row.begin_s >= capability.first_s) continue;
      const double idle_s = capability.share * (capability.first_s - row.begin_s);
      row.budget_s = std::max(kLeastBudget_s, row.budget_s - idle_s);
      for (std::size_t i = row.begin; i < row.end; ++i) {
        table_.time_s[i] = std::max(0.0F, table_.time_s[i] - static_cast<float>(idle_s));
      }
    }
  }

  static constexpr std::size_t kLeftOut = std::numeric_limits<std::size_t>::max();

  LegTable table_;
  SearchWorld& world_;
  const std::vector<PreparedProblem::Member>& members_;
  const std::vector<NearLegs>& near_;
  const std::vector<double>& mass_;
  double share_ = 0.0;  ///< of the row's member
  std::uint32_t row_ = 0;
  std::vector<std::uint32_t> row_of_;  ///< per cell, the last row that shows it
  std::vector<std::size_t> entry_of_;  ///< and its entry there
};

}  // namespace

LegTable leg_table(const PreparedProblem& problem, const std::vector<NearLegs>& near, const std::vector<double>& mass) {
  return Builder(problem, near, mass).table();
}

}  // namespace tandem
