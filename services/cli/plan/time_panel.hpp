#pragma once

#include "services/cli/plan/picture_style.hpp"

namespace tandem::cli {

/// The height that the rows of the panel need [px].
[[nodiscard]] double height_of_times(const PlanPicture& picture);

/// Over one axis of time: who is at which source, what is left in the pools, how likely the object is found.
void draw_times(Svg& svg, const PanelBox& box, const PlanPicture& picture);

}  // namespace tandem::cli
