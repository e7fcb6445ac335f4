#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "gateway/protocol/messages.hpp"
#include "services/common/file_io.hpp"

namespace tandem::protocol {
namespace {

std::vector<std::filesystem::path> examples(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string{TANDEM_SOURCE_DIR} + "/gateway/protocol/examples/" + folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool is_client(const std::filesystem::path& file) {
  return file.filename().string().rfind("client_", 0) == 0;
}

/// Empty when the file's message is good, else why it is not.
std::string verdict(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  if (is_client(file)) {
    const auto parsed = parse_client_message(text);
    const auto* malformed = std::get_if<Malformed>(&parsed);
    return malformed == nullptr ? "" : malformed->reason;
  }
  const auto parsed = parse_server_message(text);
  const auto* malformed = std::get_if<Malformed>(&parsed);
  return malformed == nullptr ? "" : malformed->reason;
}

TEST(Examples, ValidOnesAreRead) {
  const auto files = examples("valid");
  EXPECT_GE(files.size(), 20u);
  for (const auto& file : files) EXPECT_EQ(verdict(file), "") << file;
}

TEST(Examples, InvalidOnesAreRefusedWithAReason) {
  const auto files = examples("invalid");
  EXPECT_GE(files.size(), 20u);
  for (const auto& file : files) EXPECT_NE(verdict(file), "") << file;
}

TEST(Examples, ValidOnesAreWrittenAsTheyWereRead) {
  for (const auto& file : examples("valid")) {
    const std::string text = read_file(file);
    if (is_client(file)) {
      const auto message = std::get<ClientMessage>(parse_client_message(text));
      EXPECT_EQ(std::get<ClientMessage>(parse_client_message(write(message))), message) << file;
    } else {
      const auto message = std::get<ServerMessage>(parse_server_message(text));
      EXPECT_EQ(std::get<ServerMessage>(parse_server_message(write(message))), message) << file;
    }
  }
}

}  // namespace
}  // namespace tandem::protocol
