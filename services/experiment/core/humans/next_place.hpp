#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "services/common/random.hpp"
#include "services/experiment/core/humans/person_world.hpp"

namespace tandem::experiment {

/// How a person who goes by their own head chooses where to go next.
class NextPlace {
 public:
  virtual ~NextPlace() = default;
  /// The next cell to go to, `ways` being those from here, given what they have looked at; none: they stay.
  [[nodiscard]] virtual std::optional<int> choose(const ShortestPaths& ways, PersonWorld& world,
                                                  const OwnMemory& memory, Rng& rng) = 0;
};

/// Where most new floor per metre is to be seen, every walk counted `overhead_m` longer than it is; anywhere once all
/// is seen. The larger the overhead, the farther the walks.
[[nodiscard]] std::unique_ptr<NextPlace> greedy_place(double overhead_m);

/// Any place.
[[nodiscard]] std::unique_ptr<NextPlace> random_place();

/// Up and down the whole area in lanes `lane_m` apart, beginning at the nearest of its ends, and then back again.
[[nodiscard]] std::unique_ptr<NextPlace> lawnmower_place(double lane_m);

/// The stops of a lawnmower: cells along lanes across the longer side of `area`, every second lane backwards.
[[nodiscard]] std::vector<int> lawnmower_stops(const SearchArea& area, double lane_m);

}  // namespace tandem::experiment
