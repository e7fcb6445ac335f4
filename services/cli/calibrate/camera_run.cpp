#include "services/cli/calibrate/camera_run.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "robot/camera/core/camera_config.hpp"
#include "services/cli/calibrate/page.hpp"
#include "services/cli/calibrate/scatter_plot.hpp"
#include "services/cli/command.hpp"
#include "services/cli/up/config_text.hpp"
#include "services/common/file_io.hpp"
#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

/// A number as camera.toml has it.
struct CameraNumber {
  const char* key;
  double value;
  double deviation;
};

std::vector<CameraNumber> numbers_of(const CameraCalibration& found) {
  const auto deviation = [&](int row) { return std::sqrt(found.covariance(row, row)); };
  const CameraModel& m = found.model;
  return {{"focal_px", m.focal_px, deviation(0)},
          {"principal_right_px", m.principal_offset_px.x(), deviation(1)},
          {"principal_down_px", m.principal_offset_px.y(), deviation(2)},
          {"radial", m.radial, deviation(3)},
          {"mount_x_m", m.position_in_base.x(), deviation(4)},
          {"mount_y_m", m.position_in_base.y(), deviation(5)},
          {"mount_z_m", m.position_in_base.z(), deviation(6)},
          {"mount_pitch_deg", to_degrees(m.pitch_rad), to_degrees(deviation(7))},
          {"mount_yaw_deg", to_degrees(m.yaw_rad), to_degrees(deviation(8))},
          {"mount_roll_deg", to_degrees(m.roll_rad), to_degrees(deviation(9))}};
}

Chessboard chessboard_of(const CameraCalibrationOptions& options) {
  Chessboard board{.square_m = options.square_m};
  if (std::sscanf(options.board.c_str(), "%dx%d", &board.columns, &board.rows) != 2 || board.columns < 3 ||
      board.rows < 3) {
    throw WrongUse{"calibrate camera: --board wants its inner corners, such as 8x5, and not " + options.board};
  }
  return board;
}

std::string residual_plot(const CameraCalibration& found, int axis, const char* title) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& off : found.residuals_px) {
    points.push_back({static_cast<double>(points.size()), off(axis)});
  }
  return scatter_plot({.title = title, .x_label = "corner, picture by picture"}, {{"calibrated", "#1f5fa8", points}});
}

std::string page_of(const BoardPictures& pictures, const CameraCalibration* found,
                    const std::vector<std::string>& missing) {
  std::string body = "<h1>Calibration of the camera</h1>\n";
  if (missing.empty()) {
    body += "<div class=\"good\"><b>Everything was found.</b> Copy camera.toml beside this page to the robot.</div>\n";
  } else {
    body += "<div class=\"bad\"><b>These pictures do not calibrate the camera.</b> Take more, and:<ul>\n";
    for (const std::string& one : missing) body += "<li>" + escaped_html(one) + "</li>\n";
    body += "</ul></div>\n";
  }
  if (found != nullptr) {
    body += "<h2>What was found</h2>\n<table>\n" + table_row({"", "value", "standard deviation"}, "th");
    for (const CameraNumber& one : numbers_of(*found)) {
      body += table_row({one.key, page_number(one.value, 4), page_number(one.deviation, 4)}, "td");
    }
    body += "</table>\n<h2>Corners: where the model has them minus where the picture shows them</h2>\n<p>" +
            page_number(found->pixel_px, 2) + " px along each axis.</p>\n" +
            residual_plot(*found, 0, "to the right [px]") + residual_plot(*found, 1, "down [px]");
  }
  body += "<h2>Pictures</h2>\n<table>\n";
  for (std::size_t i = 0; i < pictures.files.size(); ++i) {
    body += table_row({pictures.files[i], pictures.views[i].base_from_board ? "on the ground" : "held"}, "td");
  }
  for (const std::string& file : pictures.without_board) body += table_row({file, "no board found"}, "td");
  return html_page("Calibration of the camera", body + "</table>\n");
}

}  // namespace

CameraCalibrationResult run_camera_calibration(const CameraCalibrationOptions& options) {
  const std::filesystem::path config{options.config};
  const bool configured = !options.config.empty() && std::filesystem::exists(config / "camera.toml");
  std::string toml = configured ? read_file(config / "camera.toml") : "";
  const auto start = parse_config<CameraConfig>(toml, (config / "camera.toml").string());
  const BoardPictures pictures =
      board_pictures(options.pictures, options.ground, chessboard_of(options), start.model());
  CameraModel guess = start.model();
  guess.focal_px *= static_cast<double>(pictures.width_px) / guess.width_px;
  guess.width_px = pictures.width_px;
  guess.height_px = pictures.height_px;

  std::optional<CameraCalibration> found;
  std::vector<std::string> missing = missing_views(pictures.views, nullptr);
  if (missing.empty()) {
    found = calibrated_camera(pictures.views, guess, {});
    missing = missing_views(pictures.views, &*found);
  }
  CameraCalibrationResult result{.text = formatted("%zu pictures with the board, %zu without\n", pictures.views.size(),
                                                   pictures.without_board.size()),
                                 .good = missing.empty()};
  const std::filesystem::path folder{options.output};
  std::filesystem::create_directories(folder);
  if (found) {
    toml = with_value(toml, "width_px", std::to_string(pictures.width_px));
    toml = with_value(toml, "height_px", std::to_string(pictures.height_px));
    for (const CameraNumber& one : numbers_of(*found)) {
      result.text += formatted("%-20s %10.4f +- %.4f\n", one.key, one.value, one.deviation);
      toml = with_value(toml, one.key, formatted("%.6f", one.value));
    }
  }
  if (!result.good) result.text += "These pictures do not calibrate the camera; take more:\n";
  for (const std::string& one : missing) result.text += "  " + one + "\n";
  if (result.good) write_file_atomically(folder / "camera.toml", toml);
  write_file_atomically(folder / "report.html", page_of(pictures, found ? &*found : nullptr, missing));
  result.text += "written: " + folder.string() + "/" + (result.good ? "camera.toml, report.html\n" : "report.html\n");
  return result;
}

}  // namespace tandem::cli
