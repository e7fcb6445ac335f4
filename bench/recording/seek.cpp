#include "bench/recording/seek.hpp"

#include <stdexcept>

#include "services/common/clock.hpp"
#include "services/common/random.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::bench {

double seek_s(std::uint64_t size_mb) {
  constexpr std::size_t kMessageSize = 10'000;
  const test::TemporaryFolder folder;
  const auto file = folder / "large.mcap";
  const std::uint64_t count = size_mb * 1'000'000 / kMessageSize;
  recorder::write_recording(file, [count](mcap::Writer& writer) {
    Rng rng{1};
    mcap::ChannelTable channels{writer};
    const std::uint16_t channel = channels.channel_of("scan", "tandem::msg::LaserScan", "idl");
    mcap::Bytes data(kMessageSize);
    for (std::uint64_t i = 0; i < count; ++i) {
      // Cheap noise, which zstd cannot pack.
      if (i % 64 == 0) {
        for (auto& byte : data) byte = static_cast<std::uint8_t>(rng.uniform(0.0, 256.0));
      }
      for (std::size_t k = 0; k < data.size(); k += 8) data[k] = static_cast<std::uint8_t>(data[k] * 5 + i);
      channels.write(channel, 1 + i, i, data);
    }
  });
  const SteadyClock clock;
  const Time start = clock.now();
  mcap::Reader reader{mcap::file_source(file), file.string()};
  if (!reader.message_at(reader.message_count() / 2)) throw std::runtime_error("the message in the middle is missing");
  return to_seconds(clock.now() - start);
}

}  // namespace tandem::bench
