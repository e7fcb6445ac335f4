#include "services/cli/import_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/common/version.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/core/text_log.hpp"
#include "services/recorder/recording_file.hpp"
#include "services/recorder/rosbag_import.hpp"

namespace tandem::cli {
namespace {

struct ImportOptions {
  std::string file;
  std::string output;
  std::string robot = "robot1";
  std::vector<double> laser;  ///< base_from_laser, of a text log
  recorder::RosbagOptions rosbag;
};

mcap::Metadata origin_of(const ImportOptions& options, const char* kind) {
  return {"tandem",
          {{"imported_from", options.file.substr(options.file.rfind('/') + 1)},
           {"import", kind},
           {"version", version()},
           {"commit", commit()},
           {"contract_hash", contract_hash()}}};
}

void write(const ImportOptions& options, const char* kind, const std::vector<carmen::Event>& events) {
  const auto scans = std::count_if(events.begin(), events.end(), [](const carmen::Event& event) {
    return std::holds_alternative<carmen::Scan>(event);
  });
  recorder::write_recording(options.output, [&](mcap::Writer& writer) {
    writer.write(origin_of(options, kind));
    recorder::write_carmen(events, options.robot, writer);
    if (stop_requested()) throw Interrupted{};
  });
  std::fprintf(stderr, "%s: %td scans, %td odometry samples\n", options.output.c_str(), scans,
               static_cast<std::ptrdiff_t>(events.size()) - scans);
}

void run_carmen(const ImportOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  write(options, "carmen", carmen::parse_log(carmen::read_log_file(options.file), options.file));
}

void run_text(const ImportOptions& options) {
  (void)stop_requested();
  Pose2 base_from_laser;
  if (!options.laser.empty()) base_from_laser = {options.laser[0], options.laser[1], options.laser[2]};
  write(options, "text", parse_text_log(carmen::read_log_file(options.file), options.file, base_from_laser));
}

void run_rosbag(const ImportOptions& options) {
  (void)stop_requested();
  recorder::RosbagOptions rosbag = options.rosbag;
  rosbag.robot = options.robot;
  recorder::RosbagCount count;
  recorder::write_recording(options.output, [&](mcap::Writer& writer) {
    writer.write(origin_of(options, "rosbag"));
    count = recorder::import_rosbag(options.file, rosbag, writer, [] { return !stop_requested(); });
    if (stop_requested()) throw Interrupted{};
  });
  for (const std::string& frame : count.lost_lasers) {
    std::fprintf(stderr, "tandem: no transform says where %s is on the base: it is taken to be at the base's origin\n",
                 frame.c_str());
  }
  std::fprintf(stderr, "%s: %llu scans, %llu odometry samples, %llu maps\n", options.output.c_str(),
               static_cast<unsigned long long>(count.scans), static_cast<unsigned long long>(count.odometry),
               static_cast<unsigned long long>(count.maps));
  if (count.broken == 0) return;
  std::fprintf(stderr, "tandem: %llu messages are not what their type says and are left out\n",
               static_cast<unsigned long long>(count.broken));
  throw Failed{};
}

}  // namespace

void add_import_command(CLI::App& tandem) {
  CLI::App* import = add_command(tandem, "import", "Turn another program's log into a recording",
                                 "tandem import carmen intel.log.gz -o intel.mcap");
  import->require_subcommand(1);
  const auto options = std::make_shared<ImportOptions>();
  CLI::App* carmen = add_command(*import, "carmen", "CARMEN logs (ODOM, FLASER), or lines of O and S; plain or gzip",
                                 "tandem import carmen fr079.odomscan.txt.gz -o fr079.mcap");
  carmen->add_option("FILE", options->file, "Log")->required();
  carmen->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  carmen->add_option("--robot", options->robot, "Name of the robot in the messages")->capture_default_str();
  carmen->callback([options] { run_carmen(*options); });
  CLI::App* text = add_command(*import, "text", "Lines of SCAN t r1..rn and ODOM t x y theta v w; plain or gzip",
                               "tandem import text ist_17jun_2.txt.gz --laser 0.1,0,0 -o ist.mcap");
  text->add_option("FILE", options->file, "Log")->required();
  text->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  text->add_option("--robot", options->robot, "Name of the robot in the messages")->capture_default_str();
  text->add_option("--laser", options->laser, "Where the laser is on the base: X,Y,THETA [m, m, rad]")
      ->delimiter(',')
      ->expected(3);
  text->callback([options] { run_text(*options); });
  CLI::App* rosbag = add_command(
      *import, "rosbag", "Scans, odometry and maps of a ROS bag (.bag of ROS 1; .mcap, .db3 or folder of rosbag2)",
      "tandem import rosbag corridor.bag --scan /base_scan -o corridor.mcap");
  rosbag->add_option("FILE", options->file, "Bag, or folder of one")->required();
  rosbag->add_option("-o,--output", options->output, "Recording to write (.mcap)")->required();
  rosbag->add_option("--robot", options->robot, "Name of the robot in the messages")->capture_default_str();
  rosbag->add_option("--scan", options->rosbag.scan_topic, "Topic of the scans; default: the only one there is");
  rosbag->add_option("--odometry", options->rosbag.odometry_topic,
                     "Topic of the odometry; default: the only one there is, or the transform of --odom-frame");
  rosbag->add_option("--base-frame", options->rosbag.base_frame,
                     "Frame of the base; default: that of the odometry, or base_link");
  rosbag->add_option("--odom-frame", options->rosbag.odom_frame, "Frame of the odometry")->capture_default_str();
  rosbag->callback([options] { run_rosbag(*options); });
}

}  // namespace tandem::cli
