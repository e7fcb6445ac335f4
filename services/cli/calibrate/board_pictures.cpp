#include "services/cli/calibrate/board_pictures.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

std::map<std::string, Pose2> places_in(const std::filesystem::path& file) {
  std::map<std::string, Pose2> places;
  if (file.empty()) return places;
  std::istringstream lines{read_file(file)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words{line};
    std::string name;
    Pose2 place;
    double heading_deg = 0.0;
    if (!(words >> name >> place.x >> place.y >> heading_deg)) {
      throw std::runtime_error{file.string() + ":" + std::to_string(number) +
                               ": wants picture, x [m], y [m], heading [deg]"};
    }
    place.heading = from_degrees(heading_deg);
    places[name] = place;
  }
  return places;
}

std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".jpg" || ending == ".jpeg" || ending == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty()) throw std::runtime_error{folder.string() + ": it holds no pictures (.jpg, .png)"};
  return files;
}

/// The board's corners in a picture that was made `finer` times larger; a board far away is small, and is found then.
std::vector<Eigen::Vector2d> found_corners(const cv::Mat& picture, const Chessboard& board, double finer) {
  cv::Mat larger;
  cv::resize(picture, larger, {}, finer, finer, cv::INTER_CUBIC);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCornersSB(larger, {board.columns, board.rows}, corners,
                                   cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY)) {
    return {};
  }
  std::vector<Eigen::Vector2d> found;
  for (const cv::Point2f& corner : corners) {
    found.emplace_back((corner.x + 0.5) / finer - 0.5, (corner.y + 0.5) / finer - 0.5);
  }
  return found;
}

std::vector<Eigen::Vector2d> found_corners(const cv::Mat& picture, const Chessboard& board) {
  for (const double finer : {1.0, 2.0, 3.0}) {
    auto corners = found_corners(picture, board, finer);
    if (!corners.empty()) return corners;
  }
  return {};
}

/// Rows run along x and y lies to their left, seen from above; the middle of the board is the origin.
std::vector<SeenCorner> named(const std::vector<Eigen::Vector2d>& pixels, const Chessboard& board) {
  const auto columns = static_cast<std::size_t>(board.columns);
  const Eigen::Vector2d along = pixels[columns - 1] - pixels[0];
  const Eigen::Vector2d down = pixels[(static_cast<std::size_t>(board.rows) - 1) * columns] - pixels[0];
  const double side = along.x() * down.y() - along.y() * down.x() > 0.0 ? -1.0 : 1.0;  // pixels count downwards
  std::vector<SeenCorner> corners;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double column = static_cast<double>(i % columns) - 0.5 * (board.columns - 1);
    const double row = static_cast<double>(i / columns) - 0.5 * (board.rows - 1);
    corners.push_back({board.square_m * Eigen::Vector2d{column, side * row}, pixels[i]});
  }
  return corners;
}

double misfit(const BoardView& view, const CameraModel& camera) {
  double sum = 0.0;
  for (const SeenCorner& corner : view.corners) {
    const Eigen::Vector2d there = *view.base_from_board * corner.point_in_board;
    const auto pixel = pixel_of(camera, {there.x(), there.y(), 0.0});
    sum += pixel ? (*pixel - corner.pixel).norm() : std::numeric_limits<double>::infinity();
  }
  return sum;
}

/// Half a turn of the board looks the same: the one that `guess` likes better.
BoardView right_way(BoardView view, const CameraModel& guess) {
  BoardView turned = view;
  for (SeenCorner& corner : turned.corners) corner.point_in_board = -corner.point_in_board;
  return view.base_from_board && misfit(turned, guess) < misfit(view, guess) ? turned : view;
}

}  // namespace

BoardPictures board_pictures(const std::filesystem::path& folder, const std::filesystem::path& ground_file,
                             const Chessboard& board, const CameraModel& guess) {
  const std::map<std::string, Pose2> places = places_in(ground_file);
  BoardPictures result;
  for (const std::filesystem::path& file : pictures_in(folder)) {
    const std::string name = file.filename().string();
    const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (picture.empty()) throw std::runtime_error{file.string() + ": no picture"};
    if (result.width_px == 0) result.width_px = picture.cols, result.height_px = picture.rows;
    if (picture.cols != result.width_px || picture.rows != result.height_px) {
      throw std::runtime_error{file.string() + ": not of the size of the pictures before it"};
    }
    const auto pixels = found_corners(picture, board);
    if (pixels.empty()) {
      result.without_board.push_back(name);
      continue;
    }
    CameraModel sized = guess;
    sized.focal_px *= static_cast<double>(result.width_px) / guess.width_px;
    sized.width_px = result.width_px;
    sized.height_px = result.height_px;
    const auto place = places.find(name);
    BoardView view{.base_from_board = {}, .corners = named(pixels, board)};
    if (place != places.end()) view.base_from_board = place->second;
    result.views.push_back(right_way(std::move(view), sized));
    result.files.push_back(name);
  }
  return result;
}

}  // namespace tandem::cli
