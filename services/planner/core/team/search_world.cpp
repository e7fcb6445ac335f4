#include "services/planner/core/team/search_world.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace tandem {
namespace {

constexpr double kLookoutShareOfView = 1.0;

}  // namespace

SearchWorld::SearchWorld(std::vector<OccupancyGrid> layers, SearchWorldOptions options)
    : layers_(std::move(layers)), options_(std::move(options)), area_(layers_.front(), options_.area) {
  assert(!options_.searchers.empty());
  double view_max_m = 0.0;
  for (const Searcher& searcher : options_.searchers) view_max_m = std::max(view_max_m, searcher.view_max_m);
  for (const OccupancyGrid& layer : layers_) {
    sights_.push_back(std::make_unique<Observability>(layer, area_, view_max_m));
  }
  for (std::size_t i = 0; i < options_.searchers.size(); ++i) {
    const Searcher& searcher = options_.searchers[i];
    const auto same = std::ranges::find_if(
        capabilities_, [&](const Capability& known) { return same_capability(known.searcher, searcher); });
    capability_index_.push_back(static_cast<std::size_t>(same - capabilities_.begin()));
    if (same != capabilities_.end()) continue;
    Capability capability;
    capability.searcher = searcher;
    capability.options.lookout_range_m =
        i < options_.lookout_range_m.size() ? options_.lookout_range_m[i] : kLookoutShareOfView * searcher.view_max_m;
    const double range_m = capability.options.lookout_range_m;
    capability.options.least_gain_m2 = options_.least_gain_share * std::numbers::pi * range_m * range_m;
    capability.options.nearest = options_.nearest;
    capability.views = std::make_unique<ViewTable>(observability(searcher.layer), searcher);
    capability.actions = std::make_unique<ActionSet>(map(searcher.layer), *capability.views, capability.options,
                                                     options_.area.start_in_map);
    capability.book = std::make_unique<LegBook>(*capability.actions);
    capabilities_.push_back(std::move(capability));
  }
}

void SearchWorld::block(int searcher, const std::vector<BlockedDisc>& blocked, const Eigen::Vector2d& start_in_map) {
  Capability& capability = capability_of(searcher);
  capability.actions = std::make_unique<ActionSet>(map(capability.searcher.layer), *capability.views,
                                                   capability.options, start_in_map, blocked);
  capability.book = std::make_unique<LegBook>(*capability.actions);
}

bool SearchWorld::prepare_next() {
  return std::ranges::any_of(capabilities_, [](Capability& known) { return known.book->prepare_next(); });
}

void SearchWorld::forget_added_places() {
  for (Capability& capability : capabilities_) {
    capability.actions->forget_added_places();
    capability.book->forget_added_places();
  }
}

double SearchWorld::sweep_time_s(const std::vector<int>& searchers) const {
  double swept_m2ps = 0.0;
  for (const int index : searchers) {
    const Searcher& who = searcher(index);
    const double half_field_rad = 0.5 * std::min(std::numbers::pi, who.field_of_view_rad);
    swept_m2ps += 2.0 * who.view_max_m * std::sin(half_field_rad) * who.speed_mps;
  }
  return swept_m2ps > 0.0 ? area_.area_m2() / swept_m2ps : 0.0;
}

}  // namespace tandem
