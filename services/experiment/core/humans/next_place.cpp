#include "services/experiment/core/humans/next_place.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::experiment {
namespace {

constexpr double kLeastNews_m2 = 0.5;  ///< less is not worth a walk

std::optional<int> any_place(const ShortestPaths& ways, const PersonWorld& world, Rng& rng) {
  constexpr int kTries = 20;
  for (int i = 0; i < kTries; ++i) {
    const int cell = static_cast<int>(rng.index(static_cast<std::size_t>(world.area().size())));
    if (std::isfinite(world.distance_m(ways, cell))) return cell;
  }
  return std::nullopt;
}

class GreedyPlace final : public NextPlace {
 public:
  explicit GreedyPlace(double overhead_m) : overhead_m_(overhead_m) {}

  std::optional<int> choose(const ShortestPaths& ways, PersonWorld& world, const OwnMemory& memory, Rng& rng) override {
    std::optional<int> best;
    double best_score = 0.0;
    for (int cell = 0; cell < world.area().size(); ++cell) {
      const double distance_m = world.distance_m(ways, cell);
      if (!std::isfinite(distance_m)) continue;
      const double news_m2 = memory.news_m2(world, cell);
      const double score = news_m2 / (distance_m + overhead_m_);
      if (news_m2 < kLeastNews_m2 || score <= best_score) continue;
      best = cell;
      best_score = score;
    }
    return best ? best : any_place(ways, world, rng);
  }

 private:
  double overhead_m_;
};

class RandomPlace final : public NextPlace {
 public:
  std::optional<int> choose(const ShortestPaths& ways, PersonWorld& world, const OwnMemory& /*memory*/,
                            Rng& rng) override {
    return any_place(ways, world, rng);
  }
};

class LawnmowerPlace final : public NextPlace {
 public:
  explicit LawnmowerPlace(double lane_m) : lane_m_(lane_m) {}

  std::optional<int> choose(const ShortestPaths& ways, PersonWorld& world, const OwnMemory& /*memory*/,
                            Rng& /*rng*/) override {
    if (stops_.empty()) begin(world, ways);
    for (std::size_t tried = 0; tried < stops_.size(); ++tried) {
      if (next_ == stops_.size()) {
        std::ranges::reverse(stops_);
        next_ = 0;
      }
      const int stop = stops_[next_++];
      if (std::isfinite(world.distance_m(ways, stop))) return stop;
    }
    return std::nullopt;
  }

 private:
  void begin(const PersonWorld& world, const ShortestPaths& ways) {
    stops_ = lawnmower_stops(world.area(), lane_m_);
    if (!stops_.empty() && world.distance_m(ways, stops_.back()) < world.distance_m(ways, stops_.front())) {
      std::ranges::reverse(stops_);
    }
  }

  double lane_m_;
  std::vector<int> stops_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<NextPlace> greedy_place(double overhead_m) {
  return std::make_unique<GreedyPlace>(overhead_m);
}

std::unique_ptr<NextPlace> random_place() {
  return std::make_unique<RandomPlace>();
}

std::unique_ptr<NextPlace> lawnmower_place(double lane_m) {
  return std::make_unique<LawnmowerPlace>(lane_m);
}

std::vector<int> lawnmower_stops(const SearchArea& area, double lane_m) {
  const bool lanes_along_x = area.width() >= area.height();
  const int across_count = lanes_along_x ? area.height() : area.width();
  const int along_count = lanes_along_x ? area.width() : area.height();
  const int lane_cells = std::max(1, static_cast<int>(std::lround(lane_m / area.cell_size_m())));
  const auto cell = [&](int along, int across) {
    return lanes_along_x ? area.cell_of(along, across) : area.cell_of(across, along);
  };
  std::vector<int> stops;
  bool backwards = false;
  for (int first = 0; first < across_count; first += lane_cells, backwards = !backwards) {
    const int last = std::min(across_count, first + lane_cells) - 1;
    const int middle = (first + last) / 2;
    std::vector<int> lane;
    for (int along = 0; along < along_count; along += lane_cells) {
      // The floor of this stretch of the lane that is nearest to its middle.
      int nearest = -1;
      for (int off = 0; off <= last - first && nearest < 0; ++off) {
        for (const int across : {middle - off, middle + off}) {
          if (nearest < 0 && across >= first && across <= last) nearest = cell(along, across);
        }
      }
      if (nearest >= 0) lane.push_back(nearest);
    }
    if (backwards) std::ranges::reverse(lane);
    stops.insert(stops.end(), lane.begin(), lane.end());
  }
  return stops;
}

}  // namespace tandem::experiment
