#include "services/planner/core/paper/rrt_star.hpp"

#include <algorithm>
// The library copies its empty trees, bounding boxes not yet set.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <nanoflann.hpp>
#pragma GCC diagnostic pop

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kSlack_m = 0.02;  ///< of clearance, for what lies between the map's cells
constexpr double kApart_m = 0.1;   ///< no two nodes are nearer than this
constexpr std::size_t kMostNodes = 1U << 16U;

/// The nodes as nanoflann wants to see them.
struct Cloud {
  std::vector<Vector2d> points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return points[index](static_cast<Eigen::Index>(dimension));
  }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

}  // namespace

struct RrtStar::Index {
  using Tree = nanoflann::KDTreeSingleIndexDynamicAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2>;
  Cloud cloud;
  Tree tree{2, cloud, {}, kMostNodes};

  void add(const Vector2d& point) {
    cloud.points.push_back(point);
    const auto last = static_cast<std::uint32_t>(cloud.points.size() - 1);
    tree.addPoints(last, last);
  }
  [[nodiscard]] int nearest(const Vector2d& point) const {
    std::size_t node = 0;
    double distance2 = 0.0;
    nanoflann::KNNResultSet<double> result(1);
    result.init(&node, &distance2);
    tree.findNeighbors(result, point.data(), {});
    return static_cast<int>(node);
  }
};

RrtStar::RrtStar(const MotionMap& motion, double radius_m, double step_m, const Vector2d& root_in_map)
    : motion_(&motion), radius_m_(radius_m), step_m_(step_m), index_(std::make_unique<Index>()) {
  add_node(root_in_map, -1);
}
RrtStar::~RrtStar() = default;
RrtStar::RrtStar(RrtStar&&) noexcept = default;

bool RrtStar::is_free(const Vector2d& from, const Vector2d& to) const {
  return motion_->clearance_m(from, to) >= radius_m_ - kSlack_m;
}

std::vector<std::pair<int, double>> RrtStar::within(const Vector2d& point, double reach_m) const {
  std::vector<std::pair<std::size_t, double>> found;
  nanoflann::RadiusResultSet<double, std::size_t> result(reach_m * reach_m, found);
  index_->tree.findNeighbors(result, point.data(), {});
  std::vector<std::pair<int, double>> near;
  near.reserve(found.size());
  for (const auto& [node, distance2] : found) near.emplace_back(static_cast<int>(node), std::sqrt(distance2));
  std::ranges::sort(near, [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first < b.first;
  });
  return near;
}

std::vector<int> RrtStar::joined_within(const Vector2d& point_in_map, double reach_m) const {
  std::vector<int> joined;
  for (const auto& [node, distance_m] : within(point_in_map, reach_m)) {
    if (is_free(nodes_[static_cast<std::size_t>(node)].point_in_map, point_in_map)) joined.push_back(node);
  }
  return joined;
}

void RrtStar::add_node(const Vector2d& point, int parent) {
  const auto above = static_cast<std::size_t>(parent);
  const double cost_m = parent < 0 ? 0.0 : nodes_[above].cost_m + (point - nodes_[above].point_in_map).norm();
  if (parent >= 0) children_[above].push_back(static_cast<int>(nodes_.size()));
  nodes_.push_back({point, parent, cost_m});
  children_.emplace_back();
  index_->add(point);
}

void RrtStar::move_below(int node, int parent) {
  auto& siblings = children_[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(node)].parent)];
  siblings.erase(std::ranges::find(siblings, node));
  children_[static_cast<std::size_t>(parent)].push_back(node);
  nodes_[static_cast<std::size_t>(node)].parent = parent;
  std::vector<int> open{node};
  while (!open.empty()) {
    const auto at = static_cast<std::size_t>(open.back());
    open.pop_back();
    const TreeNode& above = nodes_[static_cast<std::size_t>(nodes_[at].parent)];
    nodes_[at].cost_m = above.cost_m + (nodes_[at].point_in_map - above.point_in_map).norm();
    open.insert(open.end(), children_[at].begin(), children_[at].end());
  }
}

std::optional<int> RrtStar::extend(const Vector2d& sample_in_map) {
  if (nodes_.size() >= kMostNodes) return std::nullopt;
  const Vector2d& nearest = nodes_[static_cast<std::size_t>(index_->nearest(sample_in_map))].point_in_map;
  const Vector2d away = sample_in_map - nearest;
  const double distance_m = away.norm();
  if (distance_m < kApart_m) return std::nullopt;
  const Vector2d point = distance_m > step_m_ ? nearest + away * (step_m_ / distance_m) : sample_in_map;

  // The parent that gives the shortest way; its movement must be free and no longer than a step.
  struct Neighbour {
    int node;
    double distance_m;
    double cost_m;
  };
  std::vector<Neighbour> neighbours;
  for (const auto& [node, apart_m] : within(point, step_m_ + 1e-9)) {
    if (apart_m < kApart_m) return std::nullopt;
    neighbours.push_back({node, apart_m, nodes_[static_cast<std::size_t>(node)].cost_m + apart_m});
  }
  std::ranges::stable_sort(neighbours, {}, &Neighbour::cost_m);
  const auto parent = std::ranges::find_if(neighbours, [&](const Neighbour& neighbour) {
    return is_free(nodes_[static_cast<std::size_t>(neighbour.node)].point_in_map, point);
  });
  if (parent == neighbours.end()) return std::nullopt;
  const int added = static_cast<int>(nodes_.size());
  const double cost_m = parent->cost_m;
  add_node(point, parent->node);
  for (const Neighbour& neighbour : neighbours) {
    const TreeNode& other = nodes_[static_cast<std::size_t>(neighbour.node)];
    if (cost_m + neighbour.distance_m < other.cost_m - 1e-9 && is_free(point, other.point_in_map)) {
      move_below(neighbour.node, added);
    }
  }
  return added;
}

Vector2d random_place(const MotionMap& motion, Rng& rng) {
  return motion.point(static_cast<int>(rng.index(static_cast<std::size_t>(motion.size()))));
}

}  // namespace tandem
