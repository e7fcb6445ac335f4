#include "services/localization/core/scan_information.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr std::size_t kNeighbours = 6;      ///< looked at on each side
constexpr double kNearM = 0.25;             ///< A neighbour is this close, ...
constexpr double kNearPerM = 0.03;          ///< ... and a bit further where beams are far apart.
constexpr double kLineShare = 0.15;         ///< A line is this much thinner than long.
constexpr double kNoiseShare = 0.03;        ///< of the strongest direction's information: what noise seems to tell
constexpr double kLeastDeviationM = 0.005;  ///< No map is better than this.

}  // namespace

std::vector<Eigen::Vector2d> surface_normals(std::span<const Eigen::Vector2d> endpoints_in_base) {
  std::vector<Eigen::Vector2d> normals;
  normals.reserve(endpoints_in_base.size());
  for (std::size_t i = 0; i < endpoints_in_base.size(); ++i) {
    const Eigen::Vector2d& here = endpoints_in_base[i];
    const double near_m = kNearM + kNearPerM * here.norm();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    int count = 0;
    const std::size_t first = i < kNeighbours ? 0 : i - kNeighbours;
    const std::size_t last = std::min(endpoints_in_base.size() - 1, i + kNeighbours);
    for (std::size_t k = first; k <= last; ++k) {
      const Eigen::Vector2d away = endpoints_in_base[k] - here;
      if (away.squaredNorm() > near_m * near_m) continue;
      sum += away;
      square += away * away.transpose();
      ++count;
    }
    normals.emplace_back(Eigen::Vector2d::Zero());
    if (count < 4) continue;
    const Eigen::Matrix2d spread = square / count - sum * sum.transpose() / (count * count);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(spread);
    if (axes.eigenvalues()(0) > kLineShare * axes.eigenvalues()(1)) continue;
    normals.back() = axes.eigenvectors().col(0);
  }
  return normals;
}

ScanInformation scan_information(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                                 std::span<const Eigen::Vector2d> normals_in_base, const Pose2& map_from_base,
                                 double loss_m) {
  ScanInformation result;
  const Pose2 turn{0.0, 0.0, map_from_base.heading};
  double weights = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < endpoints_in_base.size(); ++i) {
    const Eigen::Vector2d arm = turn * endpoints_in_base[i];
    const double distance_m = field.distance_m(map_from_base.position() + arm);
    const double weight = 1.0 / (1.0 + distance_m * distance_m / (loss_m * loss_m));  // Cauchy
    weights += weight * weight;
    squares += weight * weight * distance_m * distance_m;
    const Eigen::Vector2d normal = turn * normals_in_base[i];
    const Eigen::Vector3d row{normal.x(), normal.y(), normal.y() * arm.x() - normal.x() * arm.y()};
    result.information += weight * weight * row * row.transpose();
  }
  if (weights == 0.0) return result;
  result.deviation_m = std::max(kLeastDeviationM, std::sqrt(squares / weights));
  result.information /= result.deviation_m * result.deviation_m;

  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(result.information.topLeftCorner<2, 2>());
  const double strongest = axes.eigenvalues()(1);
  const double weakest = axes.eigenvalues()(0);
  if (weakest <= 0.0) return result;
  // Along the weakest axis all is scaled, the heading's share too, so that the information stays that of some scan.
  const double kept = std::max(0.0, weakest - kNoiseShare * strongest) / weakest;
  const Eigen::Vector2d weak = axes.eigenvectors().col(0);
  Eigen::Matrix3d scale = Eigen::Matrix3d::Identity();
  scale.topLeftCorner<2, 2>() += (std::sqrt(kept) - 1.0) * weak * weak.transpose();
  result.information = scale * result.information * scale;
  return result;
}

}  // namespace tandem
