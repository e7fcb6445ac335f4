#include "services/cli/report/report_page.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <stdexcept>
#include <vector>

namespace tandem::cli {
namespace {

constexpr std::string_view kPlace = "@DATA@";

std::vector<unsigned char> deflated(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::vector<unsigned char> bytes(size);
  if (compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()), static_cast<uLong>(text.size()),
                Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("the data of the report cannot be compressed: not enough memory");
  }
  bytes.resize(size);
  return bytes;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int size =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

}  // namespace

std::string report_page(std::string_view json) {
  const std::string_view page = report_template();
  const std::size_t place = page.find(kPlace);
  std::string whole{page.substr(0, place)};
  whole += base64(deflated(json));
  whole += page.substr(place + kPlace.size());
  return whole;
}

}  // namespace tandem::cli
