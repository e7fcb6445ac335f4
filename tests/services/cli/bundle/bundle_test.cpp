#include "services/cli/bundle/bundle.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "services/common/file_io.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSecond = 1'000'000'000;

/// One message a second, `seconds` of them.
void write_recording(const fs::path& file, std::uint64_t seconds) {
  std::ofstream stream{file, std::ios::binary};
  mcap::IndexedWriter writer{[&](mcap::ByteView bytes) {
                               stream.write(reinterpret_cast<const char*>(bytes.data()),
                                            static_cast<std::streamsize>(bytes.size()));
                               return stream.good();
                             },
                             {}};
  mcap::ChannelTable channels{writer};
  const mcap::Bytes data(3, std::uint8_t{7});
  const auto channel = channels.channel_of("pose", "", "");
  for (std::uint64_t i = 1; i <= seconds; ++i) EXPECT_TRUE(channels.write(channel, i * kSecond, i * kSecond, data));
  EXPECT_TRUE(writer.finish());
}

TEST(Bundle, TakesConfigurationsAndLogsButNoSecret) {
  const test::TemporaryFolder from;
  const test::TemporaryFolder to;
  write_file_atomically(from / "site.toml", "host = \"a\"\n");
  write_file_atomically(from / "gateway.key", "SECRET");
  write_file_atomically(from / "participant_link", "SECRET");
  write_file_atomically(from / "base.log", "hello\n");
  EXPECT_TRUE(fill_bundle({from.path(), from.path(), {}, {}}, to.path()).empty());
  EXPECT_EQ(read_file(to / "config" / "site.toml"), "host = \"a\"\n");
  EXPECT_EQ(read_file(to / "logs" / "base.log"), "hello\n");
  for (const auto& entry : fs::recursive_directory_iterator{to.path()}) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(read_file(entry.path()).find("SECRET"), std::string::npos) << entry.path();
  }
}

TEST(Bundle, TakesTheEndOfTheNewestRecording) {
  const test::TemporaryFolder from;
  const test::TemporaryFolder to;
  write_recording(from / "old.mcap", 5);
  write_recording(from / "new.mcap", 100);
  fs::last_write_time(from / "old.mcap", fs::last_write_time(from / "new.mcap") - std::chrono::hours{1});
  EXPECT_EQ(newest_recording(from.path()), from / "new.mcap");
  EXPECT_TRUE(fill_bundle({from.path(), {}, from.path(), std::chrono::seconds{10}}, to.path()).empty());
  mcap::Reader reader{mcap::file_source(to / "new.mcap"), "new.mcap"};
  EXPECT_TRUE(reader.complete());
  ASSERT_EQ(reader.message_count(), 11u) << "from second 90 to second 100";
  EXPECT_EQ(reader.log_time_at(0), 90 * kSecond);
}

TEST(Bundle, SaysWhatItLeftOut) {
  const test::TemporaryFolder from;
  const test::TemporaryFolder to;
  write_file_atomically(from / "torn.mcap", "no recording");
  EXPECT_EQ(fill_bundle({from.path(), from / "nowhere", from.path(), std::chrono::seconds{10}}, to.path()).size(), 2u);
  EXPECT_EQ(fill_bundle({from.path(), {}, from / "nowhere", std::chrono::seconds{10}}, to.path()).size(), 1u);
}

TEST(Bundle, KeepsWhatAProgramPrints) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(keep_output({"echo", "two", "words"}, folder / "out.txt"));
  EXPECT_EQ(read_file(folder / "out.txt"), "two words\n");
  EXPECT_FALSE(keep_output({"false"}, folder / "out.txt"));
  EXPECT_FALSE(keep_output({"no-such-program-of-ours"}, folder / "out.txt"));
}

}  // namespace
}  // namespace tandem::cli
