#include "services/localization/core/global_search.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kFinestStepM = 0.1;      ///< A finer lattice costs time and finds the same places.
constexpr std::size_t kBeamsAtOnce = 16;  ///< between two looks whether a box is still worth it
constexpr double kMostCells = 4'000'000;  ///< A larger map is searched on a coarser lattice.

}  // namespace

GlobalSearch::GlobalSearch(const OccupancyGrid& map, const LikelihoodField& field)
    : map_from_grid_(map.map_from_grid()), grid_from_map_(inverse(map.map_from_grid())) {
  const double resolution = map.resolution_m();
  const double cells = static_cast<double>(map.width()) * map.height();
  const double finest = std::max(kFinestStepM, resolution * std::sqrt(cells / kMostCells));
  const int pool = std::max(1, static_cast<int>(std::lround(finest / resolution)));
  step_m_ = pool * resolution;
  width_ = (map.width() + pool - 1) / pool;
  height_ = (map.height() + pool - 1) / pool;

  rim_ = static_cast<int>(std::ceil(kReachM / step_m_)) + (1 << kLevels);
  padded_width_ = width_ + 2 * rim_;
  padded_height_ = height_ + 2 * rim_;

  const std::size_t count = static_cast<std::size_t>(padded_width_) * static_cast<std::size_t>(padded_height_);
  Level fit(count, 0);
  Level free(count, 0);
  const double lowest = static_cast<double>(field.at(-1.0, -1.0));
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const std::size_t cell = index(column / pool, row / pool);
      const double share = 1.0 - static_cast<double>(field.at(column, row)) / lowest;
      fit[cell] = std::max(fit[cell], static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
      if (map.is_free({column, row})) free[cell] = 1;
    }
  }
  fit_.push_back(std::move(fit));
  free_.push_back(std::move(free));
  for (int level = 1; level < kLevels; ++level) {
    fit_.push_back(pooled(fit_.back(), 1 << (level - 1)));
    free_.push_back(pooled(free_.back(), 1 << (level - 1)));
  }
}

GlobalSearch::Level GlobalSearch::pooled(const Level& finer, int half) const {
  Level level(finer.size(), 0);
  const auto side = static_cast<std::size_t>(half);
  const auto width = static_cast<std::size_t>(padded_width_);
  for (std::size_t row = 0; row + side < static_cast<std::size_t>(padded_height_); ++row) {
    for (std::size_t column = 0; column + side < width; ++column) {
      const std::size_t here = row * width + column;
      const std::size_t above = here + side * width;
      level[here] = std::max({finer[here], finer[here + side], finer[above], finer[above + side]});
    }
  }
  return level;
}

std::vector<Candidate> GlobalSearch::candidates(std::span<const Eigen::Vector2d> endpoints_in_base,
                                                const GlobalSearchOptions& options) const {
  GlobalSearchRun run{*this, endpoints_in_base, options};
  while (!run.is_done()) run.advance(*this, 100'000);
  return run.candidates();
}

std::ptrdiff_t GlobalSearch::shift_of(const Eigen::Vector2d& way_m) const {
  const Eigen::Vector2d steps = way_m / step_m_;
  return std::lround(steps.y()) * padded_width_ + std::lround(steps.x());
}

std::optional<int> GlobalSearch::best_sum(int level, int column, int row, std::span<const std::ptrdiff_t> shifts,
                                          int least) const {
  const std::uint8_t* const fit = fit_[static_cast<std::size_t>(level)].data() + index(column, row);
  int reachable = 255 * static_cast<int>(shifts.size());
  while (!shifts.empty()) {
    const auto few = shifts.first(std::min(kBeamsAtOnce, shifts.size()));
    int missed = 0;
    for (const std::ptrdiff_t shift : few) missed += 255 - fit[shift];
    reachable -= missed;
    if (reachable < least) return std::nullopt;
    shifts = shifts.subspan(few.size());
  }
  return reachable;
}

double GlobalSearch::score_at(const Pose2& map_from_base, std::span<const Eigen::Vector2d> endpoints_in_base) const {
  const Pose2 grid_from_base = grid_from_map_ * map_from_base;
  int sum = 0;
  int count = 0;
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    if (endpoint.norm() >= kReachM) continue;
    ++count;
    const Eigen::Vector2d p = grid_from_base * endpoint / step_m_;
    const int column = static_cast<int>(std::floor(std::clamp(p.x(), -1.0, static_cast<double>(width_))));
    const int row = static_cast<int>(std::floor(std::clamp(p.y(), -1.0, static_cast<double>(height_))));
    sum += fit_.front()[index(column, row)];
  }
  return count > 0 ? sum / (255.0 * count) : 0.0;
}

}  // namespace tandem
