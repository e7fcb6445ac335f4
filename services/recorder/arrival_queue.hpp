#pragma once

#include <mutex>
#include <vector>

#include "services/bus/mailbox.hpp"
#include "services/recorder/core/arrival.hpp"

namespace tandem::recorder {

/// What came and is not written yet, of all topics, in the order it came. Thread-safe.
///
/// Bounded: while the disk is slow, what comes after that is dropped and counted by topic, and no writer of the bus
/// waits.
class ArrivalQueue {
 public:
  /// At most `limit_messages` of one topic, and `limit_bytes` of payload of all.
  ArrivalQueue(std::size_t sources, std::size_t limit_messages, std::size_t limit_bytes);

  void put(Arrival arrival);
  [[nodiscard]] std::vector<Arrival> take();
  /// How many were dropped so far, by source.
  [[nodiscard]] std::vector<std::uint64_t> dropped() const;

 private:
  mutable std::mutex mutex_;
  std::size_t limit_messages_;
  std::size_t limit_bytes_;
  std::vector<Arrival> arrivals_;
  std::vector<std::size_t> waiting_;  ///< messages by source
  std::vector<std::uint64_t> dropped_;
  std::size_t bytes_ = 0;
};

/// Where one topic's samples go into the queue.
class ArrivalBox final : public bus::Mailbox {
 public:
  ArrivalBox(ArrivalQueue& queue, std::size_t source) : queue_(queue), source_(source) {}
  void put(bus::RawSample sample) override;

 private:
  ArrivalQueue& queue_;
  std::size_t source_;
};

}  // namespace tandem::recorder
