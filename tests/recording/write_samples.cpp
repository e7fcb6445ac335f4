#include <cstdio>
#include <fstream>
#include <string>

#include "idl/topics.hpp"
#include "services/recorder/core/schemas.hpp"
#include "services/recorder/recording_file.hpp"

// write_samples FOLDER: recordings of one message of each topic of the contract (tests/idl/golden_bytes.txt), in every
// form that ours can have: live.mcap, none.mcap, zstd.mcap, lz4.mcap.
namespace {

using namespace tandem;

constexpr std::size_t kChunkSize = 4096;  // several chunks

mcap::Bytes bytes_of_hex(const std::string& hex) {
  mcap::Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::string type_of(const std::string& topic) {
  for (const TopicInfo& info : all_topics()) {
    if (info.name == topic) return info.make_type()->getName();
  }
  throw std::runtime_error(topic + " is in golden_bytes.txt, but no topic of the contract");
}

void fill(mcap::Writer& writer) {
  std::ifstream golden{TANDEM_SOURCE_DIR "/tests/idl/golden_bytes.txt"};
  mcap::ChannelTable channels{writer};
  writer.write(mcap::Metadata{"tandem", {{"version", "test"}}});
  writer.write(mcap::Attachment{1, 2, "config/site.toml", "application/toml", "host = \"robot\"\n"});
  std::string topic;
  std::string hex;
  for (std::uint64_t time = 1'000'000'000; golden >> topic >> hex; time += 1'000'000) {
    const std::string type = type_of(topic);
    const std::uint16_t channel = channels.channel_of(topic, type, recorder::idl_of(type));
    channels.write(channel, time, time - 500, bytes_of_hex(hex));
  }
  if (!writer.finish()) throw std::runtime_error("the recording could not be written");
}

template <typename Writer, typename... Options>
void write(const std::filesystem::path& file, Options... options) {
  recorder::RecordFile out{file};
  Writer writer{[&out](mcap::ByteView bytes) { return out.write(bytes); }, recorder::recording_header(), options...};
  fill(writer);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: write_samples FOLDER");
  const std::filesystem::path folder = argv[1];
  write<mcap::LiveWriter>(folder / "live.mcap");
  for (const auto compression : {mcap::Compression::None, mcap::Compression::Zstd, mcap::Compression::Lz4}) {
    const std::string name = compression == mcap::Compression::None ? "none" : mcap::name_of(compression);
    write<mcap::IndexedWriter>(folder / (name + ".mcap"), kChunkSize, compression);
  }
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::fprintf(stderr, "write_samples: %s\n", error.what());
  return EXIT_FAILURE;
}
