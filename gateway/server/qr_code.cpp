#include "gateway/server/qr_code.hpp"

#include <qrencode.h>

#include <memory>

namespace tandem::gateway {

std::string qr_code(const std::string& text) {
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code{QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_L),
                                                             &QRcode_free};
  if (!code) return "";
  constexpr int kQuiet = 2;
  const auto dark = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < code->width && y < code->width && (code->data[y * code->width + x] & 1) != 0;
  };
  std::string picture;
  for (int y = -kQuiet; y < code->width + kQuiet; y += 2) {
    for (int x = -kQuiet; x < code->width + kQuiet; ++x) {
      const bool upper = dark(x, y);
      const bool lower = dark(x, y + 1);
      picture += upper && lower ? " " : upper ? "▄" : lower ? "▀" : "█";  // blocks are light on a dark terminal
    }
    picture += '\n';
  }
  return picture;
}

}  // namespace tandem::gateway
