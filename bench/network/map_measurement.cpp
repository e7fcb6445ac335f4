#include "bench/network/airs.hpp"
#include "bench/network/measurements.hpp"
#include "bench/network/quantiles.hpp"
#include "bench/network/stream.hpp"
#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

using std::chrono::seconds;

constexpr Duration kPatience = seconds{20};

/// Bytes that cannot be compressed any further.
msg::CompressedMap map_of(std::size_t bytes) {
  msg::CompressedMap map;
  map.map_id("map");
  Rng rng{1};
  for (std::size_t i = 0; i < bytes; ++i) map.zstd_cells().push_back(static_cast<std::uint8_t>(rng.bits()));
  return map;
}

}  // namespace

Figures map_to_late_joiner(const std::string& whose, const std::string& air, int run, std::size_t bytes,
                           bool odometry) {
  test::Laboratory lab{{"robot", "laptop"}, seed_of(run)};
  lab.set_all(conditions_of(air));
  auto& robot_host = lab.host("robot");
  auto& laptop_host = lab.host("laptop");
  const auto laptop = make_link_side(whose, laptop_host, robot_host.address());
  const auto robot = make_link_side(whose, robot_host, laptop_host.address());
  const auto map = map_of(bytes);
  const auto writer = laptop->writer(info_of(topic::kCompressedMap));
  writer->write(bus::encode<msg::CompressedMapPubSubType>(map), bus::key_of<msg::CompressedMapPubSubType>(map));

  std::unique_ptr<Stream> stream;
  std::unique_ptr<Listener> odometry_in;
  if (odometry) {
    stream = odometry_stream(*laptop, 50.0);
    odometry_in = std::make_unique<Listener>(*robot, info_of(topic::kOdometry));
    holds_within(seconds{30}, [&] { return odometry_in->subscription->matched_writers() > 0; });
    pause(seconds{1});
    std::ignore = odometry_in->arrivals->take();
  }

  const std::uint64_t sent_before = lab.count("laptop").bytes_sent;
  const std::uint64_t stream_before = stream ? stream->sent() : 0;
  Listener joiner{*robot, info_of(topic::kCompressedMap)};
  Figures figures{{"ms", kNever}};
  const SteadyClock clock;
  if (holds_within(seconds{30}, [&] { return joiner.subscription->matched_writers() > 0; })) {
    const Time matched = clock.now();
    holds_within(kPatience, [&] {
      for (const auto& sample : joiner.arrivals->take()) figures["ms"] = to_ms(sample.received - matched);
      return figures["ms"] < kNever;
    });
  }
  figures["sent_kB"] = static_cast<double>(lab.count("laptop").bytes_sent - sent_before) / 1e3;
  if (odometry) {
    const double sent = static_cast<double>(stream->sent() - stream_before);
    std::vector<double> latencies;
    for (const auto& sample : odometry_in->arrivals->take()) {
      const auto message = bus::decode<msg::OdometryPubSubType>(sample.payload);
      if (message) latencies.push_back(to_ms(sample.received - from_stamp_ns(message->stamp_ns())));
    }
    figures["odometry_delivered"] = static_cast<double>(latencies.size()) / sent;
    figures["odometry_p99_ms"] = observed_quantile(latencies, 0.99, kNever);
  }
  return figures;
}

}  // namespace tandem::bench
