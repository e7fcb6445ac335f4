#include "services/planner/core/search/view_table.hpp"

#include <cmath>

namespace tandem {
namespace {

constexpr int kSectors = 24;

}  // namespace

ViewTable::ViewTable(Observability& observability, const Searcher& searcher)
    : observability_(&observability),
      searcher_(searcher),
      sectors_(searcher.sees_all_around() ? 1 : kSectors),
      sees_all_in_sight_(searcher.sees_all_around() && searcher.view_min_m <= 0.0 &&
                         searcher.view_max_m >= observability.range_m()) {
  if (!sees_all_in_sight_) {
    views_.resize(static_cast<std::size_t>(observability.area().size()));
    is_known_.resize(views_.size());
  }
}

int ViewTable::sector_of(double heading_rad) const {
  if (sectors_ == 1) return 0;
  const double sector_rad = 2.0 * std::numbers::pi / sectors_;
  return static_cast<int>(std::lround((wrap_to_pi(heading_rad) + std::numbers::pi) / sector_rad)) % sectors_;
}

const View& ViewTable::view(int standpoint, int sector) {
  if (sees_all_in_sight_) return observability_->in_sight_of(standpoint);
  const auto at = static_cast<std::size_t>(standpoint);
  const auto s = static_cast<std::size_t>(sector);
  if (views_[at].empty()) {
    views_[at].resize(static_cast<std::size_t>(sectors_));
    is_known_[at].resize(views_[at].size());
  }
  if (!is_known_[at][s]) {
    const Eigen::Vector2d& point = observability_->area().point(standpoint);
    const double heading_rad = sector * 2.0 * std::numbers::pi / sectors_ - std::numbers::pi;
    views_[at][s] = observability_->seen_from(searcher_, {point.x(), point.y(), heading_rad});
    is_known_[at][s] = true;
  }
  return views_[at][s];
}

}  // namespace tandem
