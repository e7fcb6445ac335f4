#include "services/cli/calibrate_command.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "services/cli/calibrate/camera_run.hpp"
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
    const WheelCalibrationResult found = run_wheel_calibration(options, [&](double share, const char* step) {
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
  command->add_option("--config", options->config,
                      "Folder with the base.toml and laser.toml that the robot drove with");
  command->add_option("--model", options->model,
                      "Model of the robot, where the recording does not say: p2at, p3dx, ...");
  command->add_flag("--json", options->json, "Result as JSON");
  command->callback([options] { run(*options); });
}

void run_camera(const CameraCalibrationOptions& options) {
  const CameraCalibrationResult result = run_camera_calibration(options);
  std::fputs(result.text.c_str(), stdout);
  if (!result.good) throw Failed{};
}

void add_camera(CLI::App& calibrate) {
  const auto options = std::make_shared<CameraCalibrationOptions>();
  CLI::App* command = add_command(calibrate, "camera", "Lens and mount of the camera, from pictures of a chessboard",
                                  "tandem calibrate camera pictures --ground ground.txt -o calibrated");
  command->add_option("PICTURES", options->pictures, "Folder of pictures (.jpg, .png)")->required();
  command->add_option("--ground", options->ground, "Where the board lay: lines of picture, x [m], y [m], heading [deg]")
      ->required();
  command->add_option("-o,--output", options->output, "Folder for camera.toml and report.html")->required();
  command->add_option("--config", options->config, "Folder with the camera.toml to start from");
  command->add_option("--board", options->board, "Inner corners, COLUMNSxROWS")->capture_default_str();
  command->add_option("--square", options->square_m, "Side of a square [m]")->capture_default_str();
  command->callback([options] { run_camera(*options); });
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
  add_camera(*calibrate);
}

}  // namespace tandem::cli
