#pragma once

#include "services/localization/core/localization_config.hpp"
#include "services/localization/core/place_finder.hpp"
#include "services/localization/core/pose_refinement.hpp"
#include "services/localization/core/setup_check.hpp"
#include "services/localization/core/sliding_window.hpp"

namespace tandem {

// What the parts of the localizer take of its configuration.

[[nodiscard]] inline PlaceFinderOptions finder_options(const LocalizationConfig& config) {
  PlaceFinderOptions options;
  options.panorama.way_m = config.panorama_way_m;
  options.weight_per_score = config.place_weight_per_score;
  options.certain_weight = config.place_certain_weight;
  options.certain_after_m = config.place_certain_m;
  return options;
}

[[nodiscard]] inline SetupCheckOptions setup_options(const LocalizationConfig& config, double resolution_m) {
  SetupCheckOptions options;
  options.scale = map_scale_options(resolution_m);
  options.panorama.way_m = config.panorama_way_m;
  return options;
}

[[nodiscard]] inline WindowOptions window_options(const LocalizationConfig& config, double resolution_m) {
  return {.scans = static_cast<std::size_t>(config.window_scans),
          .older_beams = static_cast<std::size_t>(config.filter_beams),
          .loss_m = config.refine_loss_m,
          .beam_weight = config.refine_beam_weight,
          .map_deviation_m = config.map_deviation_cells * resolution_m};
}

[[nodiscard]] inline RefinementOptions refinement_options(const LocalizationConfig& config) {
  return {.loss_m = config.refine_loss_m,
          .hit_deviation_m = config.hit_deviation_m,
          .beam_weight = config.beam_weight,
          .prior_deviation_m = config.prior_deviation_m,
          .prior_deviation_rad = config.prior_deviation_rad};
}

}  // namespace tandem
