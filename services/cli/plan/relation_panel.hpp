#pragma once

#include "services/cli/plan/picture_style.hpp"

namespace tandem::cli {

/// The height that the graph needs at this width [px].
[[nodiscard]] double height_of_relations(const PlanPicture& picture, double width);

/// The interdependence graph: who opens, silences or shares with whom; below it who does not know what, and what is to
/// be told.
void draw_relations(Svg& svg, const PanelBox& box, const PlanPicture& picture);

}  // namespace tandem::cli
