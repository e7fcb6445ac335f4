#include "bench/localization/mrpt_peer.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "services/localization/core/odometry_history.hpp"

namespace tandem::bench {
namespace {

constexpr double kAround = 0.1;  ///< of the start pose [m], [rad], as our own runs begin

/// The settings of MRPT's own demo, but for what was tried to do it justice: see README.md.
constexpr const char* kSettings = R"([KLD_options]
KLD_binSize_PHI_deg=10
KLD_binSize_XY=0.10
KLD_delta=0.01
KLD_epsilon=0.01
KLD_maxSampleSize=40000
KLD_minSampleSize=150
KLD_minSamplesPerBin=0
[PF_options]
PF_algorithm=0
resamplingMethod=3
adaptiveSampleSize=0
BETA=0.5
sampleSize=1
[DummyOdometryParams]
minStdXY=0.15
minStdPHI=4
[MetricMap]
occupancyGrid_count=1
pointsMap_count=0
likelihoodMapSelection=-1
[MetricMap_occupancyGrid_00_creationOpts]
resolution=0.05
[MetricMap_occupancyGrid_00_likelihoodOpts]
likelihoodMethod=4
LF_decimation=2
LF_stdHit=0.20
LF_maxCorrsDistance=0.30
LF_zHit=0.95
LF_zRandom=0.05
LF_maxRange=80
[LocalizationExperiment]
3DSceneFrequency=-1
experimentRepetitions=1
init_PDF_mode=1
SHOW_PROGRESS_3D_REAL_TIME=false
)";

void run(const std::string& command) {
  if (const int status = std::system((command + " </dev/null").c_str()); status != 0) {
    throw std::runtime_error{command + ": failed with status " + std::to_string(status)};
  }
}

/// CPU time of all programs that were run and have ended [ms].
double childrens_cpu_ms() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto ms = [](const timeval& time) {
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

/// The scans, each with the odometry at its time, as lines of CARMEN's ROBOTLASER1.
std::string carmen_log(const RecordedLog& log, std::vector<Time>& scan_times) {
  OdometryHistory history{from_seconds(0.2)};
  std::string lines;
  for (const LogEvent& event : log.events) {
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) {
      history.add(*odometry);
      continue;
    }
    const auto& scan = std::get<LaserScan>(event);
    const auto odometry = history.at(scan.time);
    if (!odometry) continue;
    const std::size_t count = scan.ranges_m.size();
    lines += formatted("ROBOTLASER1 0 %.9f %.9f %.9f %.1f 0.01 0 %zu", scan.angle_min_rad,
                       scan.angle_increment_rad * static_cast<double>(count - 1), scan.angle_increment_rad,
                       scan.range_max_m, count);
    for (const float range : scan.ranges_m) {
      const double range_m = std::isfinite(range) ? static_cast<double>(range) : scan.range_max_m + 1.0;
      lines += formatted(" %.3f", range_m);
    }
    const Pose2& pose = odometry->odom_from_base;
    const std::string place = formatted(" %.6f %.6f %.6f", pose.x, pose.y, pose.heading);
    const double time_s = to_seconds(scan.time.time_since_epoch());
    lines += " 0" + place + place + formatted(" 0 0 0 0 0 %.6f host %.6f\n", time_s, time_s);
    scan_times.push_back(scan.time);
  }
  return lines;
}

std::string settings(const RecordedLog& log, std::size_t particles, const std::filesystem::path& folder) {
  const Pose2& start = log.truth.front().map_from_base;
  const double heading_deg = to_degrees(start.heading);
  const std::string map = (folder / log.map_file.stem()).string() + ".gridmap.gz";
  return kSettings +
         formatted("map_file=%s\nrawlog_file=%s\nlogOutput_dir=%s\nparticles_count=%zu\n", map.c_str(),
                   (folder / "log.rawlog").c_str(), (folder / "out").c_str(), particles) +
         formatted("init_PDF_min_x=%.3f\ninit_PDF_max_x=%.3f\ninit_PDF_min_y=%.3f\ninit_PDF_max_y=%.3f\n",
                   start.x - kAround, start.x + kAround, start.y - kAround, start.y + kAround) +
         formatted("init_PDF_min_yaw_deg=%.2f\ninit_PDF_max_yaw_deg=%.2f\n", heading_deg - to_degrees(kAround),
                   heading_deg + to_degrees(kAround));
}

/// Of each line "... PDF estimation: (x,y,heading deg), ..." in turn.
std::vector<Pose2> estimates(const std::string& output) {
  std::vector<Pose2> poses;
  std::istringstream lines{output};
  for (std::string one; std::getline(lines, one);) {
    const std::size_t at = one.find("PDF estimation: (");
    if (at == std::string::npos) continue;
    Pose2 pose;
    double heading_deg = 0.0;
    if (std::sscanf(one.c_str() + at, "PDF estimation: (%lf,%lf,%lfdeg)", &pose.x, &pose.y, &heading_deg) != 3) {
      throw std::runtime_error{"pf-localization: not a pose: " + one};
    }
    pose.heading = from_degrees(heading_deg);
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

bool has_mrpt() {
  return std::system("command -v pf-localization carmen2rawlog ros-map-yaml2mrpt >/dev/null 2>&1") == 0;
}

PeerRun run_mrpt(const RecordedLog& log, std::size_t particles, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<Time> times;
  write_file_atomically(folder / "log.carmen", carmen_log(log, times));
  write_file_atomically(folder / "settings.ini", settings(log, particles, folder));
  const std::string quiet = " >" + (folder / "conversion.txt").string() + " 2>&1";
  run("carmen2rawlog -q -w -i " + (folder / "log.carmen").string() + " -o " + (folder / "log.rawlog").string() + quiet);
  run("ros-map-yaml2mrpt -q -w -i " + log.map_file.string() + " -d " + folder.string() + quiet);

  const double before_ms = childrens_cpu_ms();
  const std::filesystem::path output = folder / "output.txt";
  run("pf-localization " + (folder / "settings.ini").string() + " >" + output.string() + " 2>&1");
  const double spent_ms = childrens_cpu_ms() - before_ms;

  const std::vector<Pose2> poses = estimates(read_file(output));
  if (poses.size() != times.size() || poses.empty()) {
    throw std::runtime_error{"pf-localization gave " + std::to_string(poses.size()) + " poses for " +
                             std::to_string(times.size()) + " scans; see " + output.string()};
  }
  PeerRun result{.poses = {}, .update_ms = spent_ms / static_cast<double>(poses.size())};
  for (std::size_t i = 0; i < poses.size(); ++i) result.poses.push_back({times[i], poses[i]});
  return result;
}

}  // namespace tandem::bench
