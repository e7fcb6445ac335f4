#include "services/cli/calibrate_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "services/cli/calibrate/wheel_calibration.hpp"
#include "services/cli/command.hpp"
#include "services/cli/progress.hpp"

namespace tandem::cli {
namespace {

void run(const WheelCalibrationOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  std::string result;
  bool good = false;
  {
    Progress progress{"calibrate"};
    const WheelCalibrationResult found =
        run_wheel_calibration(options, [&](double share, const char* step) {
          progress.show(share, step);
          return !stop_requested();
        });
    if (stop_requested()) throw Interrupted{};
    result = options.json ? json_of(found) : text_of(found);
    good = found.missing.empty();
  }
  std::fputs(result.c_str(), stdout);
  if (!good) throw Failed{};
}

void add_from_recording(CLI::App& calibrate, const char* name, const char* purpose, const char* example,
                        bool hold_wheels) {
  const auto options = std::make_shared<WheelCalibrationOptions>();
  options->hold_wheels = hold_wheels;
  CLI::App* command = add_command(calibrate, name, purpose, example);
  command->add_option("RECORDING", options->recording, "Recording with odometry and scans (.mcap)")->required();
  command->add_option("-o,--output", options->output, "Folder for the TOML files and report.html")->required();
  command->add_option("--config", options->config, "Folder with the base.toml and laser.toml that the robot drove with");
  command->add_option("--model", options->model, "Model of the robot, where the recording does not say: p2at, p3dx, ...");
  command->add_flag("--json", options->json, "Result as JSON");
  command->callback([options] { run(*options); });
}

}  // namespace

void add_calibrate_command(CLI::App& tandem) {
  CLI::App* calibrate = add_command(tandem, "calibrate", "Measure the robot's own numbers from a recording",
                                    "tandem calibrate odometry drive.mcap -o calibrated --config config/lab/robot");
  calibrate->require_subcommand(1);
  add_from_recording(*calibrate, "odometry", "Wheels, track, laser and its clock at once, without targets",
                     "tandem calibrate odometry drive.mcap -o calibrated --config config/lab/robot", false);
  add_from_recording(*calibrate, "laser", "The laser and its clock alone, with wheels that are right already",
                     "tandem calibrate laser drive.mcap -o calibrated --config config/lab/robot", true);
}

}  // namespace tandem::cli
