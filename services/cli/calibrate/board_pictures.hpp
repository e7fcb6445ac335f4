#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calibration/core/camera_calibration.hpp"

namespace tandem::cli {

/// A printed chessboard: its inner corners, and the side of a square.
struct Chessboard {
  int columns = 8;
  int rows = 5;
  double square_m = 0.04;
};

/// Pictures of a board, all of one size.
struct BoardPictures {
  std::vector<BoardView> views;
  std::vector<std::string> files;  ///< of the views
  int width_px = 0;
  int height_px = 0;
  std::vector<std::string> without_board;  ///< pictures in which it was not found
};

/// Finds the board in all pictures (.jpg, .png) of `folder`. `ground_file` names those in which it lies on the ground:
/// lines of `picture x y heading`, the middle of the board from the robot's [m, m] and the way its rows run [degrees].
/// `guess` tells the two ways apart in which a board can be seen. Throws std::runtime_error on a folder without
/// pictures, pictures of different sizes, or a line that is none.
[[nodiscard]] BoardPictures board_pictures(const std::filesystem::path& folder,
                                           const std::filesystem::path& ground_file, const Chessboard& board,
                                           const CameraModel& guess);

}  // namespace tandem::cli
