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

namespace tandem::cli {
namespace {

struct ImportOptions {
  std::string file;
  std::string output;
  std::string robot = "robot1";
  std::vector<double> laser;  ///< base_from_laser, of a text log
};

void write(const ImportOptions& options, const char* kind, const std::vector<carmen::Event>& events) {
  const auto scans = std::count_if(events.begin(), events.end(), [](const carmen::Event& event) {
    return std::holds_alternative<carmen::Scan>(event);
  });
  recorder::write_recording(options.output, [&](mcap::Writer& writer) {
    writer.write(mcap::Metadata{"tandem",
                                {{"imported_from", options.file.substr(options.file.rfind('/') + 1)},
                                 {"import", kind},
                                 {"version", version()},
                                 {"commit", commit()},
                                 {"contract_hash", contract_hash()}}});
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
}

}  // namespace tandem::cli
