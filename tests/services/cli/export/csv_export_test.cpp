#include "services/cli/export/csv_export.hpp"

#include <gtest/gtest.h>

#include "services/common/file_io.hpp"
#include "services/recorder/core/disposed_record.hpp"
#include "tests/services/recorder/core/mcap_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

constexpr const char* kIdl = "module m { struct P { double x; // [m]\n string who; }; };";

/// Topic `p` with one good and one broken message, its ends, and one topic without schema.
mcap::Reader recording() {
  mcap::Bytes bytes;
  mcap::IndexedWriter writer{mcap::into(bytes), {"", "test"}};
  mcap::ChannelTable channels{writer};
  const std::uint16_t channel = channels.channel_of("p", "m::P", kIdl);
  channels.write(channel, 20, 10, mcap::Bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0xF8, 0x3F, 3, 0, 0, 0, 'a', ',', 0});
  channels.write(channel, 30, 20, mcap::Bytes{0, 1, 0, 0, 7});
  channels.write(channels.channel_of("p" + std::string{recorder::kDisposedSuffix}, "", "", "tandem_key"), 40, 0, {});
  channels.write(channels.channel_of("/others/notes", "", "", "json"), 50, 0, mcap::bytes_of("{}"));
  EXPECT_TRUE(writer.finish());
  return mcap::opened(bytes);
}

const auto kGoOn = [](double) { return true; };

TEST(CsvExport, WritesATableForEachTopicThatItsSchemaExplains) {
  const test::TemporaryFolder folder;
  mcap::Reader reader = recording();
  const auto results = export_csv(reader, folder / "csv", {}, kGoOn);
  EXPECT_EQ(read_file(folder / "csv" / "p.csv"),
            "log_time_ns,publish_time_ns,sequence,x [m],who\n20,10,0,1.5,\"a,\"\n");
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].rows, 1U);
  EXPECT_EQ(results[0].broken, 1U);
  EXPECT_EQ(results[1].topic, "/others/notes");
  EXPECT_EQ(results[1].problem, "its messages are not CDR with an IDL schema");
}

TEST(CsvExport, KeepsToTheChosenTopicsAndLeavesNothingHalf) {
  const test::TemporaryFolder folder;
  mcap::Reader reader = recording();
  EXPECT_TRUE(export_csv(reader, folder / "a", {"q*"}, kGoOn).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a"));
  EXPECT_TRUE(export_csv(reader, folder / "b", {}, [](double) { return false; }).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "b"));
}

}  // namespace
}  // namespace tandem::cli
