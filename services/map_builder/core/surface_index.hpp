#pragma once

#include <memory>

#include "services/map_builder/core/surface.hpp"

namespace tandem {

/// Finds the nearest point of a surface quickly (a k-d tree).
class SurfaceIndex {
 public:
  explicit SurfaceIndex(Surface surface);
  ~SurfaceIndex();
  SurfaceIndex(SurfaceIndex&&) noexcept;
  SurfaceIndex& operator=(SurfaceIndex&&) noexcept;

  [[nodiscard]] const Surface& surface() const;
  /// The point nearest to `point` [m] within `reach_m`; null if there is none.
  [[nodiscard]] const SurfacePoint* nearest(const Eigen::Vector2d& point, double reach_m) const;

 private:
  struct Tree;  ///< keeps the tree's library out of this header
  std::unique_ptr<Tree> tree_;
};

}  // namespace tandem
