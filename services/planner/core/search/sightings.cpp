#include "services/planner/core/search/sightings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kBorder_m = 1e-6;  ///< borders so near to each other are crossed at once

/// Collects what is in view in consecutive spans of time.
class Collector {
 public:
  explicit Collector(ViewTable& views)
      : views_(views), latest_(static_cast<std::size_t>(views.observability().area().size()), -1) {}

  void span(int standpoint, int sector, double from_s, double to_s) {
    if (standpoint < 0 || to_s <= from_s) return;
    for (const int cell : views_.view(standpoint, sector)) {
      std::int32_t& latest = latest_[static_cast<std::size_t>(cell)];
      if (latest >= 0 && seen_.leave_s[static_cast<std::size_t>(latest)] >= from_s) {
        seen_.leave_s[static_cast<std::size_t>(latest)] = to_s;
        continue;
      }
      latest = static_cast<std::int32_t>(seen_.size());
      seen_.cells.push_back(cell);
      seen_.enter_s.push_back(from_s);
      seen_.leave_s.push_back(to_s);
    }
  }
  Sightings take() { return std::move(seen_); }

 private:
  ViewTable& views_;
  std::vector<std::int32_t> latest_;  ///< per cell its last sighting, -1 none
  Sightings seen_;
};

/// The standpoint of the block at a place, given in cells of the area.
int standpoint_of(const Observability& observability, const Vector2d& place_in_cells) {
  const Vector2d block = place_in_cells.array().floor().max(-1.0).min(1e6);
  return observability.standpoint(static_cast<int>(block.x()), static_cast<int>(block.y()));
}

/// The shares of the way from `from` to `to` (in cells) at which a coordinate becomes whole.
void add_crossings(double from, double to, std::vector<double>& shares) {
  if (from == to) return;
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  for (double line = std::ceil(low); line <= high; line += 1.0) shares.push_back((line - from) / (to - from));
}

}  // namespace

Sightings sightings_along(const TimedPath& path, double initial_heading_rad, ViewTable& views) {
  const Observability& observability = views.observability();
  const SearchArea& area = observability.area();
  Collector collector(views);
  int sector = views.sector_of(initial_heading_rad);
  std::vector<double> shares;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const TimedPoint& from = path.points[i - 1];
    const TimedPoint& to = path.points[i];
    const double duration_s = to.time_s - from.time_s;
    const Vector2d start = (from.point_in_map - area.origin_in_map()) / area.cell_size_m();
    const Vector2d way = (to.point_in_map - from.point_in_map) / area.cell_size_m();
    if (way.norm() * area.cell_size_m() >= 1e-9) {
      sector = views.sector_of(heading_towards(from.point_in_map, to.point_in_map));
    }
    shares.assign({0.0, 1.0});
    add_crossings(start.x(), start.x() + way.x(), shares);
    add_crossings(start.y(), start.y() + way.y(), shares);
    std::sort(shares.begin(), shares.end());
    // Through the corner of a cell both borders are crossed at once; rounding must not put a third cell in between.
    const double apart = kBorder_m / std::max(kBorder_m, way.norm() * area.cell_size_m());
    const auto is_same = [apart](double a, double b) { return b - a < apart; };
    shares.erase(std::unique(shares.begin(), shares.end(), is_same), shares.end());
    shares.front() = 0.0;
    shares.back() = 1.0;
    for (std::size_t k = 1; k < shares.size(); ++k) {
      const double a = shares[k - 1];
      const double b = shares[k];
      const int standpoint = standpoint_of(observability, start + 0.5 * (a + b) * way);
      collector.span(standpoint, sector, from.time_s + a * duration_s, from.time_s + b * duration_s);
    }
  }
  return collector.take();
}

Sightings sightings_of_stay(const Pose2& pose, ViewTable& views) {
  const SearchArea& area = views.observability().area();
  Collector collector(views);
  const int standpoint =
      standpoint_of(views.observability(), (pose.position() - area.origin_in_map()) / area.cell_size_m());
  collector.span(standpoint, views.sector_of(pose.heading), 0.0, std::numeric_limits<double>::infinity());
  return collector.take();
}

}  // namespace tandem
