#include "robot/camera/jpeg.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

namespace tandem {

std::vector<std::uint8_t> jpeg_of(const cv::Mat& picture, std::size_t most_bytes) {
  for (const int quality : {85, 60, 35, 15}) {
    std::vector<std::uint8_t> bytes;
    if (cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality}) && bytes.size() <= most_bytes) {
      return bytes;
    }
  }
  return {};
}

cv::Mat surroundings(const cv::Mat& picture, const cv::Rect& box_px) {
  const int margin = std::max({40, box_px.width, box_px.height});
  const cv::Rect wanted{box_px.x - margin, box_px.y - margin, box_px.width + 2 * margin, box_px.height + 2 * margin};
  return picture(wanted & cv::Rect{0, 0, picture.cols, picture.rows});
}

}  // namespace tandem
