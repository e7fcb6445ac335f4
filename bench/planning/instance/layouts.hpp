#pragma once

#include "bench/planning/instance/floor_plan.hpp"
#include "services/common/random.hpp"

namespace tandem::bench {

/// Walls between the knots of a 5-m lattice, a column on each other knot, like the paper's square: 30 x 25 m.
///
/// `low_walls`: every second wall is only 1.8 m high, so that a drone flies and looks over it.
[[nodiscard]] FloorPlan walls_and_columns(Rng& rng, bool low_walls);

/// A small flat of two to four rooms with doors, 8 x 8 m.
[[nodiscard]] FloorPlan small_rooms(Rng& rng);

/// An office floor, 125 x 80 m: rooms on both sides of corridors.
[[nodiscard]] FloorPlan office_floor(Rng& rng, bool low_walls);

/// An open square with kiosks and columns, 125 x 80 m.
[[nodiscard]] FloorPlan plaza(Rng& rng);

/// Buildings with rooms on open ground, 400 x 250 m.
[[nodiscard]] FloorPlan campus(Rng& rng);

/// The square of config/maps/brl.plan.json, always the same: a colonnade beside an open strip.
[[nodiscard]] FloorPlan brl_square();

}  // namespace tandem::bench
