#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

#include "bench/network/quantiles.hpp"
#include "bench/network/record.hpp"
#include "bench/network/sides.hpp"
#include "services/common/clock.hpp"

namespace tandem::bench {

/// Sends what `payload` makes, at a fixed rate, on a thread of its own, for as long as it lives.
class Stream {
 public:
  using Payload = std::function<std::vector<std::uint8_t>(std::uint64_t number, Time now)>;
  Stream(Side& side, const TopicInfo& topic, double rate_hz, Payload payload, const bus::KeyHash& key);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  [[nodiscard]] std::uint64_t sent() const { return sent_; }

 private:
  std::unique_ptr<bus::RawWriter> writer_;
  std::atomic<std::uint64_t> sent_ = 0;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

/// The robot's pose; `number` stands in its odometry_epoch.
[[nodiscard]] std::unique_ptr<Stream> pose_stream(Side& side, double rate_hz);
/// The team's plan, without a path.
[[nodiscard]] std::unique_ptr<Stream> plan_stream(Side& side, double rate_hz);
/// Odometry of about 200 bytes.
[[nodiscard]] std::unique_ptr<Stream> odometry_stream(Side& side, double rate_hz);

/// Sleeps.
void pause(Duration duration);
/// Asks `condition` each millisecond. False after `timeout`.
bool holds_within(Duration timeout, const std::function<bool()>& condition);

/// ms from `began` to the first of the samples that arrived at `listener` since the last call and were sent from then
/// on; kNever if there is none.
template <class PubSubType>
[[nodiscard]] double ms_to_first(Listener& listener, Time began) {
  double ms = kNever;
  for (const auto& sample : listener.arrivals->take()) {
    const auto message = bus::decode<PubSubType>(sample.payload);
    if (message && message->stamp_ns() >= to_stamp_ns(began)) ms = std::min(ms, to_ms(sample.received - began));
  }
  return ms;
}

/// ms from now until a pose that was sent from now on arrives at `listener`; kNever after `patience`.
[[nodiscard]] double ms_to_next_pose(Listener& listener, Duration patience);

}  // namespace tandem::bench
