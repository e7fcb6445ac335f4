#include "services/recorder/recording_file.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <random>

#include "tests/services/recorder/core/mcap_files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::recorder {
namespace {

/// A number that a process leaves behind when it is killed.
class SharedCount {
 public:
  SharedCount()
      : count_(static_cast<std::atomic<std::uint64_t>*>(
            mmap(nullptr, sizeof(*count_), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~SharedCount() { munmap(count_, sizeof(*count_)); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  std::atomic<std::uint64_t>& value() { return *count_; }

 private:
  std::atomic<std::uint64_t>* count_;
};

/// Records until it is killed: messages that hold their number, and counts those that were written; at `last` the file
/// is closed and compacted, as the recorder does at its end.
[[noreturn]] void record_until_killed(const std::filesystem::path& path, std::uint64_t last,
                                      std::atomic<std::uint64_t>& written) {
  RecordFile file{path};
  mcap::LiveWriter writer{[&file](mcap::ByteView record) { return file.write(record); }, recording_header()};
  mcap::ChannelTable channels{writer};
  const std::uint16_t channel = channels.channel_of("odometry", "tandem::msg::Odometry", "idl");
  for (std::uint64_t number = 1; number <= last; ++number) {
    const std::string text(200, static_cast<char>('a' + number % 26));
    channels.write(channel, number, number, mcap::bytes_of(text));
    written = number;
  }
  if (writer.finish()) compact_recording(path);
  for (;;) pause();
}

class KilledRecorder : public testing::TestWithParam<int> {};

TEST_P(KilledRecorder, LosesNothingAndItsFileOpensByItself) {
  const test::TemporaryFolder folder;
  const auto path = folder / "a.mcap";
  SharedCount written;
  std::mt19937 random{static_cast<std::uint32_t>(GetParam())};
  const std::uint64_t kill_after = random() % 4000;  // some while it records, some while it compacts
  const std::uint64_t last = 3000;
  const pid_t child = fork();
  if (child == 0) record_until_killed(path, last, written.value());
  while (written.value() < std::min(kill_after, last)) usleep(50);
  usleep(static_cast<useconds_t>(random() % 3000));  // anywhere between two records, or in the compaction
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);

  if (!std::filesystem::exists(path)) return;  // killed before it began
  mcap::Reader reader{mcap::file_source(path), "a.mcap"};
  EXPECT_GE(reader.message_count(), written.value());
  EXPECT_LE(reader.message_count(), written.value() + 1);  // written, but not yet counted
  EXPECT_TRUE(reader.damages().empty());
  for (std::size_t i = 0; i < reader.message_count(); ++i) EXPECT_TRUE(reader.message_at(i));
}

INSTANTIATE_TEST_SUITE_P(AtRandomMoments, KilledRecorder, testing::Range(0, 20));

TEST(RecordingFile, CanBeRewrittenInPlaceWithoutWhatIsDamaged) {
  const test::TemporaryFolder folder;
  const auto path = folder / "a.mcap";
  mcap::Bytes bytes = mcap::live_file(10);
  const std::string scan = "scan 4";
  const auto at = std::search(bytes.begin(), bytes.end(), scan.begin(), scan.end());
  *(at - 22 - 3) ^= 0x40;  // the length of its record
  {
    RecordFile file{path};
    ASSERT_TRUE(file.write(bytes));
  }
  {
    mcap::Reader reader{mcap::file_source(path), "a.mcap", mcap::ReadBy::Records};
    rewrite_recording(reader, path);
    EXPECT_EQ(reader.damages().size(), 1U);
  }
  mcap::Reader reader{mcap::file_source(path), "a.mcap"};
  EXPECT_TRUE(reader.complete());
  EXPECT_EQ(reader.message_count(), 19U);
  EXPECT_EQ(reader.attachments().size(), 1U);
}

}  // namespace
}  // namespace tandem::recorder
