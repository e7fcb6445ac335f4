#include "services/recorder/arrival_queue.hpp"

#include <algorithm>

namespace tandem::recorder {

ArrivalQueue::ArrivalQueue(std::size_t sources, std::size_t limit_messages, std::size_t limit_bytes)
    : limit_messages_(limit_messages), limit_bytes_(limit_bytes), waiting_(sources), dropped_(sources) {}

void ArrivalQueue::put(Arrival arrival) {
  const std::lock_guard lock{mutex_};
  if (waiting_[arrival.source] >= limit_messages_ || bytes_ + arrival.payload.size() > limit_bytes_) {
    ++dropped_[arrival.source];
    return;
  }
  ++waiting_[arrival.source];
  bytes_ += arrival.payload.size();
  arrivals_.push_back(std::move(arrival));
}

std::vector<Arrival> ArrivalQueue::take() {
  std::vector<Arrival> taken;
  {
    const std::lock_guard lock{mutex_};
    taken.swap(arrivals_);
    std::fill(waiting_.begin(), waiting_.end(), 0);
    bytes_ = 0;
  }
  // Topics come on threads of their own.
  std::stable_sort(taken.begin(), taken.end(),
                   [](const Arrival& a, const Arrival& b) { return a.received < b.received; });
  return taken;
}

std::vector<std::uint64_t> ArrivalQueue::dropped() const {
  const std::lock_guard lock{mutex_};
  return dropped_;
}

void ArrivalBox::put(bus::RawSample sample) {
  const bool is_disposed = sample.kind == bus::RawSample::Kind::Disposed;
  if (!is_disposed && sample.kind != bus::RawSample::Kind::Data) return;  // a writer that ends is no event of the topic
  queue_.put({source_, is_disposed, std::move(sample.payload), sample.key, sample.received, sample.source_time});
}

}  // namespace tandem::recorder
