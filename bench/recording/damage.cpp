#include "bench/recording/damage.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "services/common/random.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::bench {
namespace {

constexpr std::size_t kMessages = 500;
constexpr std::size_t kMessageSize = 2000;
constexpr std::size_t kChunkSize = 64 << 10;

/// A file, where its records end, and how many messages are in those up to there.
struct File {
  mcap::Bytes bytes;
  std::vector<std::size_t> ends;
  std::vector<std::size_t> messages;
};

void fill(mcap::Writer& writer) {
  Rng rng{1};
  mcap::ChannelTable channels{writer};
  const std::uint16_t channel = channels.channel_of("scan", "tandem::msg::LaserScan", "idl");
  for (std::uint64_t i = 0; i < kMessages; ++i) {
    mcap::Bytes data(kMessageSize);
    for (auto& byte : data) byte = static_cast<std::uint8_t>(rng.uniform(0.0, 256.0));
    channels.write(channel, 1000 + i, i, data);
  }
  (void)writer.finish();
}

std::size_t messages_in(const mcap::Bytes& bytes) {
  mcap::Reader reader{mcap::memory_source(bytes), "damaged.mcap", mcap::ReadBy::Records};
  std::size_t count = 0;
  for (std::size_t i = 0; i < reader.message_count(); ++i) count += reader.message_at(i).has_value() ? 1 : 0;
  return count;
}

/// Without a compression: a live, unchunked file.
File file_of(std::optional<mcap::Compression> compression) {
  File file;
  const auto sink = [&file](mcap::ByteView record) {
    file.bytes.insert(file.bytes.end(), record.begin(), record.end());
    file.ends.push_back(file.bytes.size());
    const bool holds_messages = record[0] == static_cast<std::uint8_t>(mcap::Opcode::Message) ||
                                record[0] == static_cast<std::uint8_t>(mcap::Opcode::Chunk);
    const std::size_t before = file.messages.empty() ? 0 : file.messages.back();
    file.messages.push_back(holds_messages ? messages_in(file.bytes) : before);
    return true;
  };
  if (compression) {
    mcap::IndexedWriter writer{sink, {"", "bench"}, kChunkSize, *compression};
    fill(writer);
  } else {
    mcap::LiveWriter writer{sink, {"", "bench"}};
    fill(writer);
  }
  return file;
}

std::vector<File> files() {
  std::vector<File> all;
  all.push_back(file_of(std::nullopt));
  for (const auto compression : {mcap::Compression::Zstd, mcap::Compression::Lz4}) all.push_back(file_of(compression));
  return all;
}

/// The number of the record that holds byte `at`.
std::size_t record_with(const File& file, std::size_t at) {
  return static_cast<std::size_t>(std::upper_bound(file.ends.begin(), file.ends.end(), at) - file.ends.begin());
}

std::size_t messages_of_record(const File& file, std::size_t record) {
  return file.messages[record] - (record == 0 ? 0 : file.messages[record - 1]);
}

}  // namespace

DamageResult cut_everywhere(std::size_t step) {
  DamageResult result;
  for (const File& file : files()) {
    for (std::size_t cut = 0; cut < file.bytes.size(); cut += step) {
      const std::size_t whole = record_with(file, cut);
      const std::size_t expected = whole == 0 ? 0 : file.messages[whole - 1];
      ++result.tried;
      if (messages_in({file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(cut)}) != expected) {
        ++result.failed;
      }
    }
  }
  return result;
}

DamageResult flip_bits(std::size_t times) {
  DamageResult result;
  Rng rng{7};
  for (const File& file : files()) {
    for (std::size_t i = 0; i < times; ++i) {
      mcap::Bytes bytes = file.bytes;
      std::vector<std::size_t> hit;
      for (std::size_t flips = 1 + i % 5; flips > 0; --flips) {
        const double place = rng.uniform(sizeof(mcap::kMagic), static_cast<double>(bytes.size()));
        const auto at = static_cast<std::size_t>(place);
        bytes[at] ^= static_cast<std::uint8_t>(1U << static_cast<unsigned>(rng.uniform(0.0, 8.0)));
        hit.push_back(record_with(file, at));
      }
      std::sort(hit.begin(), hit.end());
      hit.erase(std::unique(hit.begin(), hit.end()), hit.end());
      std::size_t at_least = kMessages;
      for (const std::size_t record : hit) at_least -= messages_of_record(file, record);
      ++result.tried;
      if (messages_in(bytes) < at_least) ++result.failed;
    }
  }
  return result;
}

}  // namespace tandem::bench
