#include "services/localization/core/surface_normals.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
namespace {

constexpr std::size_t kNeighbours = 6;      ///< looked at on each side
constexpr double kNearM = 0.25;             ///< A neighbour is this close, ...
constexpr double kNearPerM = 0.03;          ///< ... and a bit further where beams are far apart.
constexpr std::size_t kFewest = 4;          ///< points that make a line
constexpr double kStray = 2.0;              ///< Points this many deviations off a line are not of it.
constexpr double kExactM = 0.005;           ///< ... beyond what no laser tells
constexpr double kLineShare = 0.15;         ///< A line is this much thinner than long, as variances, ...
constexpr std::size_t kGrazed = 2;          ///< neighbours on each side where beams are too far apart
constexpr double kGrazedLineShare = 0.003;  ///< ... and there so much, ...
constexpr double kGapRatio = 4.0;           ///< ... with no gap wider by more than this than another: no corner.

struct Line {
  Eigen::Vector2d middle;
  Eigen::Vector2d normal;
  double deviation_m = 0.0;  ///< of the points, across it
  double thinness = 0.0;     ///< variance across over variance along
};

Line line_through(std::span<const Eigen::Vector2d> points) {
  const auto count = static_cast<double>(points.size());
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) middle += point / count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& point : points) spread += (point - middle) * (point - middle).transpose() / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(spread);
  const double least = std::max(0.0, axes.eigenvalues()(0));
  const double most = axes.eigenvalues()(1);
  return {middle, axes.eigenvectors().col(0), std::sqrt(least), most > 0.0 ? least / most : 1.0};
}

/// Direction across the line through most of `points`; zero if they form none.
Eigen::Vector2d across_most(std::vector<Eigen::Vector2d> points) {
  if (points.size() < kFewest) return Eigen::Vector2d::Zero();
  const Line rough = line_through(points);
  std::erase_if(points, [&](const Eigen::Vector2d& point) {
    return std::abs(rough.normal.dot(point - rough.middle)) > kStray * rough.deviation_m + kExactM;
  });
  if (points.size() < kFewest) return Eigen::Vector2d::Zero();
  const Line line = line_through(points);
  return line.thinness > kLineShare ? Eigen::Vector2d::Zero() : line.normal;
}

/// Direction across the surface that successive beams met far apart; zero if it was not one.
Eigen::Vector2d across_grazed(std::span<const Eigen::Vector2d> points) {
  double narrowest_m = std::numeric_limits<double>::infinity();
  double widest_m = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double gap_m = (points[i] - points[i - 1]).norm();
    narrowest_m = std::min(narrowest_m, gap_m);
    widest_m = std::max(widest_m, gap_m);
  }
  if (widest_m > kGapRatio * narrowest_m) return Eigen::Vector2d::Zero();
  const Line line = line_through(points);
  return line.thinness > kGrazedLineShare ? Eigen::Vector2d::Zero() : line.normal;
}

/// The endpoints close to that of beam `i`, itself among them.
std::vector<Eigen::Vector2d> close_to(std::size_t i, std::span<const Eigen::Vector2d> endpoints_in_base) {
  const Eigen::Vector2d& here = endpoints_in_base[i];
  const double near_m = kNearM + kNearPerM * here.norm();
  const std::size_t first = i < kNeighbours ? 0 : i - kNeighbours;
  const std::size_t last = std::min(endpoints_in_base.size() - 1, i + kNeighbours);
  std::vector<Eigen::Vector2d> points;
  for (std::size_t k = first; k <= last; ++k) {
    if ((endpoints_in_base[k] - here).squaredNorm() <= near_m * near_m) points.push_back(endpoints_in_base[k]);
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> surface_normals(std::span<const Eigen::Vector2d> endpoints_in_base) {
  std::vector<Eigen::Vector2d> normals;
  normals.reserve(endpoints_in_base.size());
  for (std::size_t i = 0; i < endpoints_in_base.size(); ++i) {
    std::vector<Eigen::Vector2d> close = close_to(i, endpoints_in_base);
    const bool has_both_sides = i >= kGrazed && i + kGrazed < endpoints_in_base.size();
    if (close.size() < kFewest && has_both_sides) {
      normals.push_back(across_grazed(endpoints_in_base.subspan(i - kGrazed, 2 * kGrazed + 1)));
    } else {
      normals.push_back(across_most(std::move(close)));
    }
  }
  return normals;
}

}  // namespace tandem
