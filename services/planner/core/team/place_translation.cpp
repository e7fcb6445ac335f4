#include "services/planner/core/team/place_translation.hpp"

#include <cstdint>
#include <nanoflann.hpp>

namespace tandem {
namespace {

/// The lookouts of an action set as nanoflann wants them.
struct LookoutCloud {
  const ActionSet* actions;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(actions->lookouts()); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
    return actions->place(static_cast<int>(index))[static_cast<Eigen::Index>(dimension)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, LookoutCloud>, LookoutCloud, 2,
                                                 std::uint32_t>;

}  // namespace

PlaceTranslation::PlaceTranslation(const TeamGround& ground) : members_(ground.books.size()) {
  tables_.resize(members_ * members_);
  for (std::size_t to = 0; to < members_; ++to) {
    const LookoutCloud cloud{&ground.books[to]->actions()};
    const Tree tree(2, cloud);
    for (std::size_t from = 0; from < members_; ++from) {
      const ActionSet& actions = ground.books[from]->actions();
      if (ground.books[from] == ground.books[to]) continue;
      auto& table = tables_[from * members_ + to];
      for (int place = 0; place < actions.lookouts(); ++place) {
        std::uint32_t nearest = 0;
        double distance2 = 0.0;
        const bool found = tree.knnSearch(actions.place(place).data(), 1, &nearest, &distance2) > 0;
        table.push_back(found ? static_cast<int>(nearest) : -1);
      }
    }
  }
}

}  // namespace tandem
