#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace tandem {

/// `picture` as JPEG of at most `most_bytes`, as good as fits; empty if it cannot be made so small.
[[nodiscard]] std::vector<std::uint8_t> jpeg_of(const cv::Mat& picture, std::size_t most_bytes);

/// The part of `picture` around `box_px`, with enough around it for a person to see what it is.
[[nodiscard]] cv::Mat surroundings(const cv::Mat& picture, const cv::Rect& box_px);

}  // namespace tandem
