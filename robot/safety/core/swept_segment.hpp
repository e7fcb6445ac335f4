#pragma once

#include <Eigen/Core>

#include "robot/safety/core/swept_path.hpp"

namespace tandem::safety {

/// A straight edge, in the frame of the base [m].
struct Segment {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// The distance from the hull to `edge_in_base`; 0 where they overlap [m].
[[nodiscard]] double distance_to_hull(const Hull& hull, const Segment& edge_in_base);

/// When the hull, going on as `motion` says, touches `edge_in_base` [s]; infinite if never. 0 where they overlap.
///
/// Exact: first contact is an end of the edge on the hull's outline, or a corner of the hull on the edge. As with
/// points, `margin_m` grows the hull, and an edge in the margin alone counts only while it comes closer.
[[nodiscard]] double time_to_contact(const Hull& hull, double margin_m, const Motion& motion,
                                     const Segment& edge_in_base);

}  // namespace tandem::safety
