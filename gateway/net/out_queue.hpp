#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>

namespace tandem::net {

/// One WebSocket message to a phone.
struct Frame {
  bool binary = false;
  std::string data;
};

/// What waits to be written to one phone: the newest of each topic, and everything else in order.
///
/// A slow phone misses states, never messages; one that lets `max_items` or `max_bytes` of messages pile up is too slow
/// to be served and is to be closed. Messages go first, then topics by name.
class OutQueue {
 public:
  OutQueue(std::size_t max_items, std::size_t max_bytes) : max_items_(max_items), max_bytes_(max_bytes) {}

  /// Adds a message that must arrive. False when there is no room: the phone is too slow.
  [[nodiscard]] bool push(Frame frame) {
    if (messages_.size() >= max_items_ || bytes_ + frame.data.size() > max_bytes_) return false;
    bytes_ += frame.data.size();
    messages_.push_back(std::move(frame));
    return true;
  }

  /// Sets the newest of `topic`; one that still waits is replaced and counted.
  void set_latest(const std::string& topic, Frame frame) {
    const bool replaced = !latest_.insert_or_assign(topic, std::move(frame)).second;
    if (replaced) ++coalesced_;
  }

  [[nodiscard]] std::optional<Frame> take() {
    if (!messages_.empty()) {
      Frame frame = std::move(messages_.front());
      messages_.pop_front();
      bytes_ -= frame.data.size();
      return frame;
    }
    if (latest_.empty()) return std::nullopt;
    Frame frame = std::move(latest_.begin()->second);
    latest_.erase(latest_.begin());
    return frame;
  }

  [[nodiscard]] std::size_t coalesced() const { return coalesced_; }

 private:
  std::size_t max_items_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::size_t coalesced_ = 0;
  std::deque<Frame> messages_;
  std::map<std::string, Frame> latest_;
};

}  // namespace tandem::net
