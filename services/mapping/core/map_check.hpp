#pragma once

#include <string>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// What can be wrong with a map.
enum class MapFault {
  NothingKnown,   ///< every cell is unknown
  NoFreeSpace,    ///< nowhere to drive
  NoWalls,        ///< nothing to localize on
  TooSmall,       ///< for a place that a robot drives in
  TooLarge,       ///< for a place that a robot drives in
  CellsTooLarge,  ///< a doorway would vanish
  CellsTooSmall,  ///< more cells than the place is worth
  WallsTooThick,  ///< as drawn with the wrong scale, or smeared
  NarrowSpace,    ///< no room for a robot anywhere: the scale is too small
  TornSpace,      ///< free space in parts that do not hang together
  UnknownAreas,   ///< holes amid the free space
  OpenBorder,     ///< free space that ends at the image's edge
};

/// Does it keep a robot from using the map, or is it only worth a look?
enum class Severity { Fault, Hint };

/// One thing that was found.
struct MapFinding {
  MapFault fault{};
  Severity severity = Severity::Fault;
  std::string what;   ///< with figures
  std::string where;  ///< in the map's metres; empty where it is about the whole
  std::string advice;
};

/// A word for programs: "walls_too_thick".
[[nodiscard]] const char* name_of(MapFault fault);

/// Figures of a map.
struct MapSummary {
  double width_m = 0.0;   ///< of the part in which anything is known
  double height_m = 0.0;  ///< ...
  double free_m2 = 0.0;
  double occupied_m2 = 0.0;
  double unknown_m2 = 0.0;        ///< within that part
  double largest_free_m2 = 0.0;   ///< hanging together
  double wall_thickness_m = 0.0;  ///< median
  double widest_m = 0.0;          ///< diameter of the largest empty circle in the largest free space
};

struct MapCheck {
  MapSummary summary;
  std::vector<MapFinding> findings;  ///< faults first
};

/// Looks at a map as a robot would use it.
[[nodiscard]] MapCheck check_map(const OccupancyGrid& map);

/// Is any of the findings a fault?
[[nodiscard]] bool has_faults(const MapCheck& check);

}  // namespace tandem
