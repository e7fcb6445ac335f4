#include "services/mapping/core/distance_field.hpp"

#include <array>
#include <cassert>

namespace tandem {
namespace {

constexpr float kFar = 1e12F;  ///< Squared cells: farther than any map is wide.

/// The lower envelope of parabolas f[q] + (x - q)^2, sampled at the integers; in place in `values`, `step` apart.
class Envelope {
 public:
  explicit Envelope(std::size_t longest) : f_(longest), parabola_(longest), from_(longest + 1) {}

  void transform(float* values, std::size_t count, std::size_t step) {
    for (std::size_t i = 0; i < count; ++i) f_[i] = values[i * step];
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::size_t last = 0;
    parabola_[0] = 0;
    from_[0] = -kInfinity;
    from_[1] = kInfinity;
    for (std::size_t q = 1; q < count; ++q) {
      double crossing = crossing_of(q, parabola_[last]);
      while (crossing <= from_[last]) crossing = crossing_of(q, parabola_[--last]);
      parabola_[++last] = q;
      from_[last] = crossing;
      from_[last + 1] = kInfinity;
    }
    std::size_t k = 0;
    for (std::size_t q = 0; q < count; ++q) {
      while (from_[k + 1] < static_cast<double>(q)) ++k;
      const double away = static_cast<double>(q) - static_cast<double>(parabola_[k]);
      values[q * step] = std::min(kFar, static_cast<float>(away * away + f_[parabola_[k]]));
    }
  }

 private:
  /// Where the parabola of `q` begins to be lower than that of `r` < `q`.
  [[nodiscard]] double crossing_of(std::size_t q, std::size_t r) const {
    const auto dq = static_cast<double>(q);
    const auto dr = static_cast<double>(r);
    return ((static_cast<double>(f_[q]) + dq * dq) - (static_cast<double>(f_[r]) + dr * dr)) / (2.0 * (dq - dr));
  }

  std::vector<float> f_;
  std::vector<std::size_t> parabola_;
  std::vector<double> from_;
};

/// Catmull-Rom weights of four neighbours at `t` in [0, 1) between the second and the third, and their derivatives.
struct CubicWeights {
  explicit CubicWeights(double t)
      : value{0.5 * t * (-1.0 + t * (2.0 - t)), 0.5 * (2.0 + t * t * (-5.0 + 3.0 * t)),
              0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)},
        slope{0.5 * (-1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * (-10.0 + 9.0 * t), 0.5 * (1.0 + t * (8.0 - 9.0 * t)),
              0.5 * t * (3.0 * t - 2.0)} {}
  std::array<double, 4> value;
  std::array<double, 4> slope;
};

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, double max_distance_m, Obstacles obstacles)
    : width_(grid.width()), height_(grid.height()), frame_(0, 0, grid.resolution_m(), grid.map_from_grid()) {
  const auto width = static_cast<std::size_t>(width_);
  const auto height = static_cast<std::size_t>(height_);
  distances_m_.resize(width * height);
  for (std::size_t i = 0; i < distances_m_.size(); ++i) {
    const CellState state = grid.cells()[i];
    const bool obstacle =
        state == CellState::Occupied || (obstacles == Obstacles::OccupiedOrUnknown && state == CellState::Unknown);
    distances_m_[i] = obstacle ? 0.0F : kFar;
  }
  if (distances_m_.empty()) return;

  Envelope envelope{std::max(width, height)};
  for (std::size_t row = 0; row < height; ++row) envelope.transform(&distances_m_[row * width], width, 1);
  for (std::size_t column = 0; column < width; ++column) envelope.transform(&distances_m_[column], height, width);

  const auto resolution = static_cast<float>(grid.resolution_m());
  const auto max_distance = static_cast<float>(std::min(max_distance_m, 1e6));
  for (float& distance : distances_m_) distance = std::min(max_distance, std::sqrt(distance) * resolution);
}

double DistanceField::distance_m(const Eigen::Vector2d& point_in_map) const {
  assert(!empty());
  const Eigen::Vector2d p = frame_.in_cells(point_in_map);
  const double x = std::clamp(p.x() - 0.5, 0.0, width_ - 1.0);
  const double y = std::clamp(p.y() - 0.5, 0.0, height_ - 1.0);
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const double u = x - column;
  const double v = y - row;
  return (1.0 - v) * ((1.0 - u) * at({column, row}) + u * at({column + 1, row})) +
         v * ((1.0 - u) * at({column, row + 1}) + u * at({column + 1, row + 1}));
}

DistanceAndGradient DistanceField::smooth(const Eigen::Vector2d& point_in_map) const {
  assert(!empty());
  const Eigen::Vector2d p = frame_.in_cells(point_in_map);
  const double x = p.x() - 0.5;
  const double y = p.y() - 0.5;
  const bool inside = x >= 0.0 && y >= 0.0 && x <= width_ - 1.0 && y <= height_ - 1.0;
  if (!inside) return {distance_m(point_in_map), Eigen::Vector2d::Zero()};

  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const CubicWeights along_x{x - column};
  const CubicWeights along_y{y - row};
  double value = 0.0;
  Eigen::Vector2d slope_per_cell = Eigen::Vector2d::Zero();
  for (int j = 0; j < 4; ++j) {
    double row_value = 0.0;
    double row_slope = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double distance = at({column - 1 + i, row - 1 + j});
      row_value += along_x.value[i] * distance;
      row_slope += along_x.slope[i] * distance;
    }
    value += along_y.value[j] * row_value;
    slope_per_cell += Eigen::Vector2d{along_y.value[j] * row_slope, along_y.slope[j] * row_value};
  }
  const Pose2 turn{0.0, 0.0, frame_.map_from_grid().heading};
  return {value, turn * Eigen::Vector2d{slope_per_cell / frame_.resolution_m()}};
}

}  // namespace tandem
