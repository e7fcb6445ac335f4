#include "services/mapping/core/map_image.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tandem {
namespace {

std::string complaint_about(const std::string& bytes) {
  try {
    (void)image_size(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MapImage, ReadsTheSizeOfAPgmWithComments) {
  const ImageSize size = image_size("P5\n# made by hand\n3 2\n255\nabcdef");
  EXPECT_EQ(size.width, 3);
  EXPECT_EQ(size.height, 2);
}

TEST(MapImage, ReadsTheSizeOfAPng) {
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\2\0\0\0\3\b\0\0\0\0crc.", 33);
  const ImageSize size = image_size(png);
  EXPECT_EQ(size.width, 258);
  EXPECT_EQ(size.height, 3);
}

TEST(MapImage, ACorruptMapImageIsRefusedWithWhatIsWrong) {
  EXPECT_EQ(complaint_about("GIF89a"), "neither a PGM nor a PNG image");
  EXPECT_EQ(complaint_about("P5\n3 2\n255\nabc"), "the file ends early: 3 x 2 pixels do not fit in 14 bytes");
  EXPECT_EQ(complaint_about("P5\n3"), "height is missing in the header");
  EXPECT_EQ(complaint_about("P5\n0 2\n255\n"), "the image has no pixels");
  EXPECT_EQ(complaint_about("P5\n99999999999999999999 2\n255\n"), "width in the header is absurd");
  EXPECT_EQ(complaint_about("P5\n1 1\n70000\nxx"), "the maximum value is not in 1..65535");
}

}  // namespace
}  // namespace tandem
