#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace tandem::test {

/// The folder of recorded test data: $TANDEM_DATA, else shared/data beside the source tree.
[[nodiscard]] inline std::filesystem::path data_folder() {
  const char* named = std::getenv("TANDEM_DATA");
  if (named != nullptr) return named;
  return std::filesystem::path{TANDEM_SOURCE_DIR} / ".." / "shared" / "data";
}

/// Must tests fail rather than skip when data is absent?
[[nodiscard]] inline bool data_is_required() {
  const char* required = std::getenv("TANDEM_REQUIRE_DATA");
  return required != nullptr && std::string{required} == "1";
}

}  // namespace tandem::test

/// Skips the test, with the reason, when `file` (a path within the data folder) is absent; fails it where data is
/// required.
#define TANDEM_NEEDS_DATA(file)                                                                     \
  if (!std::filesystem::exists(tandem::test::data_folder() / (file))) {                             \
    if (tandem::test::data_is_required()) FAIL() << "test data is required and absent: " << (file); \
    GTEST_SKIP() << "test data is absent: " << (tandem::test::data_folder() / (file)).string();     \
  }
