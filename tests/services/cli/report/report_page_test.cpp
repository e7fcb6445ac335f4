#include "services/cli/report/report_page.hpp"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <vector>

namespace tandem::cli {
namespace {

/// The data in a page, as its script unpacks them.
std::string unpacked(const std::string& page) {
  const std::string before = "id=\"data\">";
  const auto begin = page.find(before) + before.size();
  const std::string packed = page.substr(begin, page.find('<', begin) - begin);
  std::vector<unsigned char> bytes(packed.size());
  const int size = EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(packed.data()),
                                   static_cast<int>(packed.size()));
  std::string text(1 << 20, '\0');
  uLongf length = text.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &length, bytes.data(), static_cast<uLong>(size)), Z_OK);
  text.resize(length);
  return text;
}

TEST(ReportPage, HoldsItsData) {
  const std::string json = R"({"title":"<b>&amp; \"odd\" </script>"})";
  EXPECT_EQ(unpacked(report_page(json)), json);
}

TEST(ReportPage, AsksForNothingFromTheNetwork) {
  const std::string page = report_page("{}");
  for (const char* asks : {"<link rel=\"stylesheet\"", "src=\"", "import(", "@import"}) {
    EXPECT_EQ(page.find(asks), std::string::npos) << asks;
  }
  EXPECT_LT(page.size(), 400'000U);
}

}  // namespace
}  // namespace tandem::cli
