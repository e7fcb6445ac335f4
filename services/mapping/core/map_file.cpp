#include "services/mapping/core/map_file.hpp"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <locale>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <vector>

#include "services/common/file_io.hpp"
#include "services/mapping/core/map_image.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem {
namespace {

constexpr std::uintmax_t kMaxYamlBytes = 16 * 1024;  ///< A map file has six short lines; more is a mistake or malice.

/// The keys of a map_server YAML file, with messages that say file and line.
class MapYaml {
 public:
  explicit MapYaml(const std::filesystem::path& file) : file_(file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size > kMaxYamlBytes) throw MapError{file.string() + ": too long for a map file"};
    try {
      root_ = YAML::Load(read_file(file));
    } catch (const YAML::Exception& problem) {
      throw MapError{place(problem.mark) + problem.msg};
    } catch (const FileError& problem) {
      throw MapError{problem.what()};
    }
    if (!root_.IsMap()) throw MapError{place({}) + "not a map file: expected image, resolution, origin"};
  }

  [[nodiscard]] std::string text(const char* key) const { return as<std::string>(key, required(key), "a text"); }
  [[nodiscard]] double number(const char* key) const { return finite(key, required(key)); }
  [[nodiscard]] double number(const char* key, double otherwise) const {
    const YAML::Node node = root_[key];
    return node ? finite(key, node) : otherwise;
  }
  [[nodiscard]] bool flag(const char* key) const {
    const YAML::Node node = root_[key];
    if (!node) return false;
    const auto word = as<std::string>(key, node, "0 or 1");
    if (word == "1" || word == "true") return true;
    if (word == "0" || word == "false") return false;
    throw error(key, word + " is not 0 or 1");
  }
  [[nodiscard]] Pose2 pose(const char* key) const {
    const YAML::Node node = required(key);
    if (!node.IsSequence() || node.size() != 3) throw error(key, "expected [x, y, yaw]");
    return {finite(key, node[0]), finite(key, node[1]), wrap_to_pi(finite(key, node[2]))};
  }
  /// "maps/hs.yaml:2: resolution: `what`"
  [[nodiscard]] MapError error(const char* key, const std::string& what) const {
    const YAML::Node node = root_[key];
    return MapError{place(node ? node.Mark() : YAML::Mark{}) + key + ": " + what};
  }

 private:
  [[nodiscard]] YAML::Node required(const char* key) const {
    const YAML::Node node = root_[key];
    if (!node) throw MapError{place({}) + key + " is missing"};
    return node;
  }
  template <typename T>
  [[nodiscard]] T as(const char* key, const YAML::Node& node, const char* expected) const {
    try {
      return node.as<T>();
    } catch (const YAML::Exception&) {
      throw error(key, std::string{"expected "} + expected);
    }
  }
  [[nodiscard]] double finite(const char* key, const YAML::Node& node) const {
    const auto value = as<double>(key, node, "a number");
    if (!std::isfinite(value) || std::abs(value) > 1e6) throw error(key, node.Scalar() + " is not a sensible number");
    return value;
  }
  [[nodiscard]] std::string place(const YAML::Mark& mark) const {
    return file_.string() + ":" + std::to_string(std::max(mark.line, 0) + 1) + ": ";
  }

  std::filesystem::path file_;
  YAML::Node root_;
};

/// The image the file names, as grey values; checked against the limit before it is decoded.
cv::Mat read_image(const MapYaml& yaml, const std::filesystem::path& folder, std::int64_t max_cells) {
  const std::filesystem::path image = folder / yaml.text("image");
  try {
    const std::string bytes = read_file(image);
    const ImageSize size = image_size(bytes);
    if (size.width * size.height > max_cells) {
      throw yaml.error("image", image.string() + ": " + std::to_string(size.width) + " x " +
                                    std::to_string(size.height) + " cells are more than the limit of " +
                                    std::to_string(max_cells));
    }
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));  // NOLINT
    cv::Mat pixels = cv::imdecode(encoded, cv::IMREAD_GRAYSCALE);
    if (pixels.cols != size.width || pixels.rows != size.height) throw std::runtime_error{"the image is corrupt"};
    return pixels;
  } catch (const MapError&) {
    throw;
  } catch (const FileError& problem) {
    throw yaml.error("image", problem.what());
  } catch (const std::exception& problem) {
    throw yaml.error("image", image.string() + ": " + problem.what());
  }
}

}  // namespace

OccupancyGrid load_map(const std::filesystem::path& yaml_file, std::int64_t max_cells) {
  const MapYaml yaml{yaml_file};
  const double resolution_m = yaml.number("resolution");
  if (!(resolution_m >= 1e-3 && resolution_m <= 100.0)) throw yaml.error("resolution", "not within [0.001, 100] m");
  const Pose2 map_from_grid = yaml.pose("origin");
  const double occupied_above = yaml.number("occupied_thresh", 0.65);
  const double free_below = yaml.number("free_thresh", 0.196);
  if (!(free_below >= 0.0 && free_below <= occupied_above && occupied_above <= 1.0)) {
    throw yaml.error("free_thresh", "0 <= free_thresh <= occupied_thresh <= 1 does not hold");
  }
  const bool negate = yaml.flag("negate");
  const cv::Mat pixels = read_image(yaml, yaml_file.parent_path(), max_cells);

  std::array<CellState, 256> state_of{};
  for (int value = 0; value < 256; ++value) {
    const double occupancy = (negate ? value : 255 - value) / 255.0;
    state_of[value] = occupancy > occupied_above ? CellState::Occupied
                      : occupancy < free_below   ? CellState::Free
                                                 : CellState::Unknown;
  }
  OccupancyGrid grid{pixels.cols, pixels.rows, resolution_m, map_from_grid};
  for (int row = 0; row < grid.height(); ++row) {
    const auto* line = pixels.ptr<std::uint8_t>(grid.height() - 1 - row);
    for (int column = 0; column < grid.width(); ++column) grid.set({column, row}, state_of[line[column]]);
  }
  return grid;
}

void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml_file) {
  const std::string image = map_id_of(yaml_file) + ".pgm";
  std::string pgm = "P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n";
  for (int row = grid.height() - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width(); ++column) {
      const CellState state = grid.at(CellIndex{column, row});
      pgm += static_cast<char>(state == CellState::Occupied ? 0 : state == CellState::Free ? 254 : 205);
    }
  }
  std::ostringstream yaml;
  yaml.imbue(std::locale::classic());
  yaml.precision(17);
  const Pose2& origin = grid.map_from_grid();
  yaml << "image: " << image << "\nresolution: " << grid.resolution_m() << "\norigin: [" << origin.x << ", " << origin.y
       << ", " << origin.heading << "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  write_file_atomically(yaml_file.parent_path() / image, pgm);
  write_file_atomically(yaml_file, yaml.str());
}

std::string map_id_of(const std::filesystem::path& yaml_file) {
  return yaml_file.stem().string();
}

std::string sha256_of_cells(const OccupancyGrid& grid) {
  return sha256_hex({reinterpret_cast<const char*>(grid.cells().data()), grid.cells().size()});
}

}  // namespace tandem
