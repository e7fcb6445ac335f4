#include "services/map_builder/core/surface.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/surface_normals.hpp"

namespace tandem {

Surface surface_of(std::span<const Eigen::Vector2d> endpoints_in_base, const Eigen::Vector2d& laser_in_base,
                   std::size_t count) {
  const std::vector<Eigen::Vector2d> normals = surface_normals(endpoints_in_base);
  Surface surface;
  surface.reserve(endpoints_in_base.size());
  for (std::size_t i = 0; i < endpoints_in_base.size(); ++i) {
    const bool away = normals[i].dot(endpoints_in_base[i] - laser_in_base) > 0.0;
    surface.push_back({endpoints_in_base[i], away ? Eigen::Vector2d{-normals[i]} : normals[i]});
  }
  return evenly(std::span<const SurfacePoint>{surface}, count);
}

Surface operator*(const Pose2& a_from_b, const Surface& surface_in_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  Surface surface;
  surface.reserve(surface_in_b.size());
  for (const SurfacePoint& p : surface_in_b) surface.push_back({turn * p.point + a_from_b.position(), turn * p.normal});
  return surface;
}

void SurfaceUnion::add(const Pose2& a_from_b, const Surface& surface_in_b) {
  for (const SurfacePoint& point : a_from_b* surface_in_b) {
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    if (is_new(point.point)) points_.push_back(point);
  }
}

Surface SurfaceUnion::take() {
  slots_.clear();
  return std::exchange(points_, {});
}

bool SurfaceUnion::is_new(const Eigen::Vector2d& point) {
  const auto cell_of = [this](const Eigen::Vector2d& p) {
    return std::pair{std::llround(p.x() * cells_per_m_), std::llround(p.y() * cells_per_m_)};
  };
  const auto cell = cell_of(point);
  const auto hash = static_cast<std::uint64_t>(cell.first) * 0x9E3779B97F4A7C15ULL ^
                    static_cast<std::uint64_t>(cell.second) * 0xC2B2AE3D27D4EB4FULL;
  std::size_t slot = (hash ^ (hash >> 29)) & (slots_.size() - 1);
  while (slots_[slot] != 0) {
    if (cell_of(points_[slots_[slot] - 1].point) == cell) return false;
    slot = (slot + 1) & (slots_.size() - 1);
  }
  slots_[slot] = points_.size() + 1;
  return true;
}

void SurfaceUnion::grow() {
  const Surface before = std::exchange(points_, {});
  slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), 0);
  for (const SurfacePoint& point : before) {
    if (is_new(point.point)) points_.push_back(point);
  }
}

}  // namespace tandem
