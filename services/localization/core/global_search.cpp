#include "services/localization/core/global_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

constexpr double kFinestStepM = 0.1;      ///< A finer lattice costs time and finds the same places.
constexpr double kMostCells = 4'000'000;  ///< A larger map is searched on a coarser lattice.
constexpr int kLevels = 7;                ///< The largest box is 2^6 lattice steps wide.

/// A box of positions at one heading.
struct Box {
  int score = 0;  ///< sum over the beams, never below that of any pose in the box
  int heading = 0;
  int level = 0;
  int column = 0;
  int row = 0;

  /// Highest score first; then an order of its own, so that equal inputs give equal results.
  friend bool operator<(const Box& a, const Box& b) {
    return std::tie(a.score, b.level, b.heading, b.row, b.column) <
           std::tie(b.score, a.level, a.heading, a.row, a.column);
  }
};

/// The lattice positions and headings of an area; without one, all there are.
class Limits {
 public:
  Limits(const std::optional<PoseArea>& area, const Pose2& grid_from_map, double step_m, int width, int height)
      : last_column_(width - 1), last_row_(height - 1) {
    if (!area) return;
    const Pose2 centre = grid_from_map * area->centre_in_map;
    const auto lattice = [step_m](double at_m) {
      return static_cast<int>(std::floor(std::clamp(at_m / step_m, -1e6, 1e6)));
    };
    first_column_ = std::max(first_column_, lattice(centre.x - area->half_side_m));
    first_row_ = std::max(first_row_, lattice(centre.y - area->half_side_m));
    last_column_ = std::min(last_column_, lattice(centre.x + area->half_side_m));
    last_row_ = std::min(last_row_, lattice(centre.y + area->half_side_m));
    heading_rad_ = centre.heading;
    half_turn_rad_ = area->half_turn_rad;
  }
  [[nodiscard]] bool meets(int column, int row, int side) const {
    return column <= last_column_ && row <= last_row_ && column + side > first_column_ && row + side > first_row_;
  }
  [[nodiscard]] bool has_heading(double heading_rad) const {
    return std::abs(turn_between(heading_rad_, heading_rad)) <= half_turn_rad_;
  }

 private:
  int first_column_ = 0;
  int first_row_ = 0;
  int last_column_;
  int last_row_;
  double heading_rad_ = 0.0;
  double half_turn_rad_ = 4.0;
};

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
  std::vector<Candidate> found;
  std::vector<Eigen::Vector2d> near;
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    if (endpoint.norm() < kReachM) near.push_back(endpoint);
  }
  if (near.empty()) return found;

  const int headings = std::max(1, static_cast<int>(std::ceil(2.0 * std::numbers::pi / options.step_rad)));
  std::vector<std::vector<std::ptrdiff_t>> shifts(static_cast<std::size_t>(headings));  // from the base to the ends
  const Limits limits{options.within, grid_from_map_, step_m_, width_, height_};
  const auto heading_of = [&](int heading) { return wrap_to_pi(2.0 * std::numbers::pi * heading / headings); };
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if (!limits.has_heading(heading_of(static_cast<int>(i)))) continue;
    const Pose2 turn{0.0, 0.0, 2.0 * std::numbers::pi * static_cast<double>(i) / headings};
    for (const Eigen::Vector2d& endpoint : near) {
      const Eigen::Vector2d p = turn * endpoint / step_m_;
      shifts[i].push_back(std::lround(p.y()) * padded_width_ + std::lround(p.x()));
    }
  }
  const double full = 255.0 * static_cast<double>(near.size());

  std::priority_queue<Box> boxes;
  const auto consider = [&](int heading, int level, int column, int row) {
    if (!limits.meets(column, row, 1 << level)) return;
    const std::size_t base = index(column, row);
    if (free_[static_cast<std::size_t>(level)][base] == 0) return;
    int sum = 0;
    const std::uint8_t* const fit = fit_[static_cast<std::size_t>(level)].data() + base;
    for (const std::ptrdiff_t shift : shifts[static_cast<std::size_t>(heading)]) sum += fit[shift];
    if (!found.empty() && sum < (found.front().score - options.margin) * full) return;
    boxes.push({sum, heading, level, column, row});
  };
  const int top = kLevels - 1;
  for (int heading = 0; heading < headings; ++heading) {
    if (!limits.has_heading(heading_of(heading))) continue;
    for (int row = 0; row < height_; row += 1 << top) {
      for (int column = 0; column < width_; column += 1 << top) consider(heading, top, column, row);
    }
  }
  const auto is_known = [&](const Box& box) {
    const double half_m = 0.5 * step_m_ * (1 << box.level);
    const Eigen::Vector2d middle{box.column * step_m_ + half_m, box.row * step_m_ + half_m};
    return std::any_of(found.begin(), found.end(), [&](const Candidate& candidate) {
      return (candidate.map_from_base.position() - middle).norm() + half_m < options.apart_m &&
             std::abs(turn_between(candidate.map_from_base.heading, heading_of(box.heading))) < options.apart_rad;
    });
  };
  for (std::size_t opened = 0; !boxes.empty() && opened < options.max_nodes; ++opened) {
    const Box box = boxes.top();
    boxes.pop();
    const double score = box.score / full;
    if (!found.empty() && score < found.front().score - options.margin) break;
    if (is_known(box)) continue;
    if (box.level == 0) {  // no box left can be better
      found.push_back({{(box.column + 0.5) * step_m_, (box.row + 0.5) * step_m_, heading_of(box.heading)}, score});
      if (found.size() == options.count) break;
      continue;
    }
    const int half = 1 << (box.level - 1);
    for (const int row : {box.row, box.row + half}) {
      for (const int column : {box.column, box.column + half}) consider(box.heading, box.level - 1, column, row);
    }
  }
  for (Candidate& candidate : found) candidate.map_from_base = map_from_grid_ * candidate.map_from_base;
  return found;
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
