#include "services/map_builder/core/surface_index.hpp"

#include <cstdint>
#include <nanoflann.hpp>

namespace tandem {
namespace {

/// The points as nanoflann wants them.
struct Cloud {
  Surface surface;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return surface.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return surface[index].point[static_cast<Eigen::Index>(dimension)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

/// One neighbour, no further than a limit: branches beyond it are never entered.
class NearestWithin {
 public:
  using DistanceType = double;
  explicit NearestWithin(double reach_m) : distance2_(reach_m * reach_m) {}
  [[nodiscard]] std::size_t size() const { return found ? 1 : 0; }
  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] double worstDist() const { return distance2_; }
  bool addPoint(double distance2, std::uint32_t at) {
    if (distance2 < distance2_) {
      distance2_ = distance2;
      index = at;
      found = true;
    }
    return true;
  }
  bool found = false;
  std::uint32_t index = 0;

 private:
  double distance2_;
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::uint32_t>;

}  // namespace

struct SurfaceIndex::Tree {
  explicit Tree(Surface surface) : cloud{std::move(surface)}, tree(2, cloud) {}
  Cloud cloud;
  KdTree tree;
};

SurfaceIndex::SurfaceIndex(Surface surface) : tree_(std::make_unique<Tree>(std::move(surface))) {}
SurfaceIndex::~SurfaceIndex() = default;
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;

const Surface& SurfaceIndex::surface() const {
  return tree_->cloud.surface;
}

const SurfacePoint* SurfaceIndex::nearest(const Eigen::Vector2d& point, double reach_m) const {
  if (tree_->cloud.surface.empty()) return nullptr;
  NearestWithin result{reach_m};
  tree_->tree.findNeighbors(result, point.data(), nanoflann::SearchParams{});
  return result.found ? &tree_->cloud.surface[result.index] : nullptr;
}

}  // namespace tandem
