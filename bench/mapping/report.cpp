#include "bench/mapping/report.hpp"

#include <algorithm>
#include <cstdio>

#include "bench/mapping/log_map.hpp"
#include "bench/mapping/revisits.hpp"
#include "bench/planning/report/plot.hpp"
#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "services/common/version.hpp"
#include "services/localization/core/trajectory_picture.hpp"
#include "services/mapping/core/map_check.hpp"

namespace tandem::bench {
namespace {

/// A way of building whose figures are shown.
struct Variant {
  std::string name;
  MapBuilderConfig config;
};

std::vector<Variant> variants() {
  Variant whole{.name = "default", .config = {}};
  Variant coarse = whole;
  coarse.name = "neighbours not laid onto each other";
  coarse.config.refine_rounds = 0;
  Variant open = coarse;
  open.name = "... and no closures";
  open.config.closure_score = 1.0;
  return {whole, coarse, open};
}

/// The tables and curves that grow from log to log.
struct Results {
  std::string accuracy;
  std::string form;
  std::string cost;
  std::string pictures;
  std::vector<Curve> relation_curves;
};

/// Share of the values below each value.
Curve distribution_of(const std::string& name, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  Curve curve{.name = name, .points = {}};
  const std::size_t step = std::max<std::size_t>(1, values.size() / 100);
  for (std::size_t i = 0; i < values.size(); i += step) {
    curve.points.emplace_back(std::max(1e-3, values[i]), static_cast<double>(i) / static_cast<double>(values.size()));
  }
  return curve;
}

std::vector<double> relation_distances_m(const MappingLog& log, const LogMap& result) {
  std::vector<double> distances;
  for (const Relation& relation : log.relations) {
    const RelationErrors one = relation_errors_of(result.map.trajectory, {&relation, 1}, log.relation_offset_s);
    if (one.compared > 0) distances.push_back(one.mean_m);
  }
  return distances;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}

void add_rows(const MappingLog& log, const Variant& variant, const LogMap& result, Results& results) {
  const std::string hash = hash_of(variant.config);
  if (!log.relations.empty()) {
    const RelationErrors e = relation_errors_of(result.map.trajectory, log.relations, log.relation_offset_s);
    results.accuracy +=
        formatted("| %s | %s | %zu of %zu | %.4f ± %.4f | %.3f ± %.3f | %s |\n", log.name.c_str(), variant.name.c_str(),
                  e.compared, log.relations.size(), e.mean_m, e.deviation_m, e.mean_deg, e.deviation_deg, hash.c_str());
  }
  const FormErrors form = form_errors_of(result.scan_poses, log.truth, 0.0);
  const auto errors = revisit_errors_m(revisits_of(log.truth, {}), result.scan_poses);
  results.form += formatted("| %s | %s | %zu, %zu | %.2f / %.2f | %zu: %.2f, %.2f, %.2f | %s |\n", log.name.c_str(),
                            variant.name.c_str(), result.map.closures.size(), result.map.rejected, form.rmse_m,
                            form.max_m, errors.size(), quantile(errors, 0.5), quantile(errors, 0.95),
                            errors.empty() ? 0.0 : errors.back(), hash.c_str());
  const std::string times = log.has_clock ? formatted("%.0f", result.recorded_s / result.cpu_s) : "no clock";
  results.cost += formatted("| %s | %s | %zu of %zu | %zu | %.0f | %.0f | %.1f | %s | %.0f | %s |\n", log.name.c_str(),
                            variant.name.c_str(), result.map.scan_poses.size(), result.scans, result.map.nodes,
                            log.way_m, result.recorded_s, result.cpu_s, times.c_str(), result.peak_mb, hash.c_str());
}

void draw(const MappingLog& log, const LogMap& result, const MappingCampaign& campaign, Results& results) {
  std::vector<PictureLink> closures;
  for (const MapClosure& closure : result.map.closures) {
    closures.push_back({closure.earlier.map_from_base.position(), closure.later.map_from_base.position()});
  }
  const Pose2 map_from_truth = inverse(form_errors_of(result.scan_poses, log.truth, 0.0).truth_from_map);
  std::vector<TimedPose> truth = log.truth;
  for (TimedPose& pose : truth) pose.map_from_base = map_from_truth * pose.map_from_base;
  const MapCheck check = check_map(result.map.grid);
  write_file_atomically(
      campaign.output / (log.name + ".svg"),
      trajectory_picture(result.map.grid, result.map.scan_poses, {.truth = truth, .closures = closures}));
  results.pictures += formatted("%s: %.0f x %.0f m, %.0f m² free, `map check`: %s\n\n![%s](%s.svg)\n\n",
                                log.name.c_str(), check.summary.width_m, check.summary.height_m, check.summary.free_m2,
                                has_faults(check) ? "faults" : "no faults", log.name.c_str(), log.name.c_str());
  if (!log.relations.empty()) {
    results.relation_curves.push_back(distribution_of(log.name, relation_distances_m(log, result)));
  }
}

std::string reference_row(const MappingLog& log) {
  if (log.relations.empty()) return "";
  const RelationErrors e = relation_errors_of(log.truth, log.relations, log.relation_offset_s);
  return formatted("| %s | the reference, straight between its scans | %zu of %zu | %.4f ± %.4f | %.3f ± %.3f | |\n",
                   log.name.c_str(), e.compared, log.relations.size(), e.mean_m, e.deviation_m, e.mean_deg,
                   e.deviation_deg);
}

std::string report_text(const Results& results) {
  return "# How true the maps are that are built from recordings\n\nCommit " + commit().substr(0, 12) +
         ", parameters " + hash_of(MapBuilderConfig{}) +
         ".\n\n    ./run bench mapping\n\nRaw odometry and scans of the logs in docs/data.md go in, nothing else; one "
         "parameter set for all, tuned on intel and fr079 alone. The other rows leave parts out. The builder draws no "
         "random numbers.\n\n## Surveyed relations\n\nError of an estimate: |inverse(relation) (+) estimated relative "
         "pose|, in position and in heading, mean ± standard deviation. The pose at a relation's times is that of the "
         "trajectory the builder writes: between scans as the wheels say. Targets: intel 0.050 m (goal 0.031), fr079 "
         "0.055 m (goal 0.045).\n\n| log | stage | relations | m | deg | parameters |\n|---|---|---|---|---|---|\n" +
         results.accuracy +
         "\n![Distribution of the errors](relations.svg)\n\n## Form, and loops\n\nThe poses of all "
         "scans laid as a whole onto the reference, which is another mapper's, good to 6 cm indoors and unknown "
         "outdoors. Revisits: places where the reference comes back within 3 m after 50 m of way, one each 5 m; the "
         "error of the estimated motion between the two visits (median, 95 %, largest).\n\n| log | stage | closures, "
         "rejected | rmse / largest m | revisits: m | parameters |\n|---|---|---|---|---|---|\n" +
         results.form +
         "\n## Cost\n\nProcessor time of one thread, with reading in; memory: the largest of the whole "
         "program, the log and the reference held in it too. frcampus has no clock: its times are scan numbers.\n\n| "
         "log | stage | scans used | nodes | way m | recorded s | CPU s | × real time | peak MB | parameters "
         "|\n|---|---|---|---|---|---|---|---|---|---|\n" +
         results.cost + "\n## Maps\n\nBlue: the way as built; orange: the reference; red: closures.\n\n" +
         results.pictures;
}

}  // namespace

void run_mapping_campaign(const MappingCampaign& campaign) {
  std::filesystem::create_directories(campaign.output);
  Results results;
  for (const std::string& name : campaign.logs) {
    const MappingLog log = load_mapping_log(name, campaign.data_folder);
    for (const Variant& variant : variants()) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), variant.name.c_str());
      const LogMap result = built(log, variant.config);
      add_rows(log, variant, result, results);
      if (variant.name == "default") draw(log, result, campaign, results);
    }
    results.accuracy += reference_row(log);
  }
  write_file_atomically(campaign.output / "relations.svg",
                        plotted(results.relation_curves, {.title = "Errors of the surveyed relations",
                                                          .x_label = "error [m]",
                                                          .y_label = "share of the relations below",
                                                          .x_logarithmic = true}));
  write_file_atomically(campaign.output / "REPORT.md", report_text(results));
}

}  // namespace tandem::bench
