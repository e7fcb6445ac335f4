#pragma once

#include "services/cli/plan/picture_style.hpp"

namespace tandem::cli {

/// The room that the place of the picture needs if it is to be no larger than this [px].
[[nodiscard]] PanelBox fitted_place(const PlanPicture& picture, const PanelBox& most);

/// Walls, belief, sources, and the agents' paths with dots at equal times. `box` is a fitted_place().
void draw_place(Svg& svg, const PanelBox& box, const PlanPicture& picture);

}  // namespace tandem::cli
