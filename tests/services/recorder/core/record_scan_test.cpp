#include "services/recorder/core/record_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::mcap {
namespace {

/// A recording and where each of its top-level records begins.
struct File {
  Bytes bytes;
  std::vector<std::size_t> records;
};

/// Pseudo-random data, as little like records as that of a compressed camera image.
Bytes noise(std::size_t size, std::uint32_t seed) {
  std::mt19937 random{seed};
  Bytes bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

template <typename MakeWriter>
File filled(MakeWriter make_writer, int messages, std::size_t message_size) {
  File file;
  auto writer = make_writer([&file](ByteView bytes) {
    file.records.push_back(file.bytes.size());
    file.bytes.insert(file.bytes.end(), bytes.begin(), bytes.end());
    return true;
  });
  ChannelTable channels{writer};
  for (int i = 0; i < messages; ++i) {
    const std::uint16_t channel = channels.channel_of(i % 2 == 0 ? "odometry" : "scan", "tandem::msg::Any", "idl");
    channels.write(channel, static_cast<std::uint64_t>(1000 + i), 0,
                   noise(message_size, static_cast<std::uint32_t>(i)));
  }
  EXPECT_TRUE(writer.finish());
  return file;
}

File live(int messages, std::size_t message_size) {
  return filled([](Sink sink) { return LiveWriter{std::move(sink), {"", "test"}}; }, messages, message_size);
}

File indexed(int messages, std::size_t message_size, std::size_t chunk_size, Compression compression) {
  return filled(
      [&](Sink sink) {
        return IndexedWriter{std::move(sink), {"", "test"}, chunk_size, compression};
      },
      messages, message_size);
}

std::vector<std::uint64_t> log_times(Reader& reader) {
  std::vector<std::uint64_t> times;
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    if (const auto message = reader.message_at(i)) times.push_back(message->log_time);
  }
  return times;
}

/// What a damage at byte `at` may cost: the log times in the record (or chunk) that holds it, nothing else.
std::set<std::uint64_t> in_record_with(const File& file, std::size_t at) {
  const auto next = std::upper_bound(file.records.begin(), file.records.end(), at);
  const std::size_t begin = *std::prev(next);
  const std::size_t end = next == file.records.end() ? file.bytes.size() : *next;
  const ByteView record = ByteView{file.bytes}.subspan(begin, end - begin);
  const ByteView content = record.subspan(kRecordHead);
  if (record[0] == static_cast<std::uint8_t>(Opcode::Message)) return {parse<Message>(content)->log_time};
  if (record[0] != static_cast<std::uint8_t>(Opcode::Chunk)) return {};
  std::set<std::uint64_t> times;
  const auto chunk = parse<Chunk>(content);
  for (std::uint64_t time = chunk->start_time; time <= chunk->end_time; ++time) times.insert(time);
  return times;
}

std::vector<std::uint64_t> all_but(int messages, const std::set<std::uint64_t>& lost) {
  std::vector<std::uint64_t> times;
  for (int i = 0; i < messages; ++i) {
    if (!lost.contains(static_cast<std::uint64_t>(1000 + i))) times.push_back(static_cast<std::uint64_t>(1000 + i));
  }
  return times;
}

std::vector<File> files_of_one_megabyte() {
  return {live(500, 2000), indexed(500, 2000, 64 << 10, Compression::None),
          indexed(500, 2000, 64 << 10, Compression::Zstd), indexed(500, 2000, 64 << 10, Compression::Lz4)};
}

TEST(RecordScan, FindsEveryRecordOfAWholeFile) {
  const File file = live(3, 10);
  const auto source = memory_source(file.bytes);
  RecordScan scan{*source, sizeof(kMagic), [](std::uint64_t, const std::string& what) { FAIL() << what; }};
  std::string opcodes;
  while (const auto record = scan.next()) opcodes += std::to_string(static_cast<int>(record->opcode)) + " ";
  EXPECT_EQ(opcodes, "1 3 4 5 4 5 5 15 2 ");
}

// Header, schema, channel, message, channel, message, ...: each record's head is damaged in each of its bits.
TEST(RecordScan, ADamagedHeadCostsItsOwnRecordAlone) {
  const int count = 8;
  const File file = live(count, 40);
  for (std::size_t i = 3; i < file.records.size() - 1; ++i) {
    if (file.bytes[file.records[i]] != static_cast<std::uint8_t>(Opcode::Message)) continue;
    for (std::size_t bit = 0; bit < 8 * kRecordHead; ++bit) {
      File damaged = file;
      const std::size_t at = file.records[i] + bit / 8;
      damaged.bytes[at] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      Reader reader = opened(damaged.bytes, ReadBy::Records);
      EXPECT_EQ(log_times(reader), all_but(count, in_record_with(file, at))) << "record " << i << " bit " << bit;
      EXPECT_EQ(reader.damages().size(), 1U) << "record " << i << " bit " << bit;
    }
  }
}

TEST(RecordScan, RecordsBetweenTwoDamagedOnesAreFound) {
  File file = live(8, 40);
  std::vector<std::size_t> messages;
  for (const std::size_t record : file.records) {
    if (file.bytes[record] == static_cast<std::uint8_t>(Opcode::Message)) messages.push_back(record);
  }
  file.bytes[messages[2] + 2] ^= 0x40;  // its length
  file.bytes[messages[4] + 2] ^= 0x40;
  Reader reader = opened(file.bytes, ReadBy::Records);
  EXPECT_EQ(log_times(reader), (std::vector<std::uint64_t>{1000, 1001, 1003, 1005, 1006, 1007}));
}

TEST(RecordScan, MessagesOutliveTheirChannelsRecord) {
  const File file = live(4, 40);
  File damaged = file;
  const auto channel = std::find_if(file.records.begin(), file.records.end(), [&file](std::size_t record) {
    return file.bytes[record] == static_cast<std::uint8_t>(Opcode::Channel);
  });
  damaged.bytes[*channel] = 0;
  Reader reader = opened(damaged.bytes, ReadBy::Records);
  EXPECT_EQ(log_times(reader), all_but(4, {}));
  EXPECT_NE(reader.channel_of("lost_channel_1"), nullptr);
}

TEST(RecordScan, AChunksDamageLeavesTheNamesThatTheSummaryHolds) {
  const File file = indexed(100, 200, 2000, Compression::Zstd);
  File damaged = file;
  damaged.bytes[200] ^= 0x01;  // in the first chunk, where schemas and channels stand
  Reader reader = opened(damaged.bytes, ReadBy::Records);
  EXPECT_EQ(log_times(reader), all_but(100, in_record_with(file, 200)));
  EXPECT_NE(reader.channel_of("odometry"), nullptr);
  EXPECT_EQ(reader.channel_of("lost_channel_1"), nullptr);
}

// Every byte around the ends of records, and a sample of all others; `./run bench recording` takes each byte.
TEST(RecordScan, AFileOfOneMegabyteCutAnywhereGivesAllWholeRecords) {
  for (const File& file : files_of_one_megabyte()) {
    ASSERT_GT(file.bytes.size(), 900'000U);
    std::set<std::size_t> cuts;
    for (std::size_t cut = 0; cut < file.bytes.size(); cut += 9973) cuts.insert(cut);
    for (std::size_t i = 0; i < file.records.size(); i += 1 + file.records.size() / 20) {
      const std::size_t first = file.records[i] < 12 ? 0 : file.records[i] - 12;
      for (std::size_t cut = first; cut < first + 24 && cut < file.bytes.size(); ++cut) cuts.insert(cut);
    }
    for (const std::size_t cut : cuts) {
      std::set<std::uint64_t> lost;
      for (const std::size_t record : file.records) {
        const auto next = std::upper_bound(file.records.begin(), file.records.end(), record);
        const std::size_t end = next == file.records.end() ? file.bytes.size() : *next;
        if (end > cut) lost.merge(in_record_with(file, record));
      }
      Reader reader =
          opened({file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(cut)}, ReadBy::Records);
      ASSERT_EQ(log_times(reader), all_but(500, lost)) << "cut at byte " << cut;
    }
  }
}

TEST(RecordScan, RandomBitFlipsCostOnlyWhatTheyHit) {
  for (const File& file : files_of_one_megabyte()) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
      std::mt19937 random{seed};
      File damaged = file;
      std::set<std::uint64_t> may_be_lost;
      for (std::uint32_t i = 0; i < 1 + seed % 5; ++i) {
        const std::size_t at = sizeof(kMagic) + random() % (file.bytes.size() - sizeof(kMagic));
        damaged.bytes[at] ^= static_cast<std::uint8_t>(1U << (random() % 8));
        may_be_lost.merge(in_record_with(file, at));
      }
      const auto expected = all_but(500, may_be_lost);
      Reader reader = opened(damaged.bytes, ReadBy::Records);
      const auto times = log_times(reader);
      EXPECT_TRUE(std::includes(times.begin(), times.end(), expected.begin(), expected.end())) << "seed " << seed;
      Reader by_index = opened(damaged.bytes);  // may miss what a damaged index hides, and says so
      EXPECT_TRUE(log_times(by_index).size() >= expected.size() || !by_index.complete()) << "seed " << seed;
    }
  }
}

TEST(RecordScan, EvenTheOpeningOfAFileMayBeGone) {
  File file = indexed(100, 200, 2000, Compression::Lz4);
  std::fill_n(file.bytes.begin(), 12, std::uint8_t{0});
  Reader reader = opened(file.bytes, ReadBy::Records);
  EXPECT_EQ(log_times(reader), all_but(100, {}));
  EXPECT_FALSE(reader.complete());
  EXPECT_THROW((void)opened(file.bytes), McapError);
  EXPECT_THROW((void)opened(noise(5000, 1), ReadBy::Records), McapError);
}

}  // namespace
}  // namespace tandem::mcap
