#include "services/localization/core/part_options.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

/// Gives each number of a config another value, so that no two can be exchanged unseen.
class Numbering final : public ConfigVisitor {
 public:
  void field(std::string_view, double& value, Range) override { value = ++last_; }
  void field(std::string_view, std::int64_t& value, Range) override { value = ++last_; }
  void field(std::string_view, bool&) override {}
  void field(std::string_view, std::string&) override {}
  void field(std::string_view, std::vector<double>&, Range) override {}
  void field(std::string_view, std::vector<std::string>&) override {}
  void field(std::string_view, std::string&, std::vector<std::string>) override {}

 private:
  int last_ = 0;
};

LocalizationConfig numbered_config() {
  LocalizationConfig config;
  Numbering numbering;
  ConfigVisitor& visitor = numbering;
  config.visit_fields(visitor);
  return config;
}

TEST(PartOptions, TheFinderOfPlacesAndTheCheckOfTheSetupLookBackEquallyFar) {
  const LocalizationConfig config = numbered_config();
  const PlaceFinderOptions finder = finder_options(config);
  EXPECT_EQ(finder.panorama.way_m, config.panorama_way_m);
  EXPECT_EQ(finder.weight_per_score, config.place_weight_per_score);
  EXPECT_EQ(finder.certain_weight, config.place_certain_weight);
  EXPECT_EQ(finder.certain_after_m, config.place_certain_m);
  EXPECT_EQ(setup_options(config, 0.05).panorama.way_m, config.panorama_way_m);
}

TEST(PartOptions, TheWindowCountsTheMapsErrorInCells) {
  LocalizationConfig config = numbered_config();
  config.map_deviation_cells = 0.5;
  const WindowOptions window = window_options(config, 0.1);
  EXPECT_DOUBLE_EQ(window.map_deviation_m, 0.05);
  EXPECT_EQ(window.scans, static_cast<std::size_t>(config.window_scans));
  EXPECT_EQ(window.older_beams, static_cast<std::size_t>(config.filter_beams));
  EXPECT_EQ(window.loss_m, config.refine_loss_m);
  EXPECT_EQ(window.beam_weight, config.refine_beam_weight);
}

TEST(PartOptions, APoseAloneIsRefinedWithTheFiltersWeightOfABeam) {
  const LocalizationConfig config = numbered_config();
  const RefinementOptions refinement = refinement_options(config);
  EXPECT_EQ(refinement.beam_weight, config.beam_weight);
  EXPECT_EQ(refinement.loss_m, config.refine_loss_m);
  EXPECT_EQ(refinement.hit_deviation_m, config.hit_deviation_m);
  EXPECT_EQ(refinement.prior_deviation_m, config.prior_deviation_m);
  EXPECT_EQ(refinement.prior_deviation_rad, config.prior_deviation_rad);
}

}  // namespace
}  // namespace tandem
