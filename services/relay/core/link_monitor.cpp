#include "services/relay/core/link_monitor.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr std::size_t kExchanges = 50;
constexpr std::uint64_t kLossWindow = 50;
constexpr double kSmoothing = 0.1;

}  // namespace

Heartbeat LinkMonitor::next_heartbeat(Time now) {
  Heartbeat heartbeat;
  heartbeat.host = own_host_;
  heartbeat.sequence_number = ++sent_;
  heartbeat.sent = now;
  if (last_heard_) {
    heartbeat.heard_host = last_heard_->host;
    heartbeat.heard_sequence_number = last_heard_->sequence_number;
    heartbeat.heard_sent = last_heard_->sent;
    heartbeat.held = now - last_heard_at_;
  }
  return heartbeat;
}

void LinkMonitor::heard(const Heartbeat& heartbeat, Time now) {
  if (heartbeat.host == own_host_) return;
  const bool restarted = last_heard_ && last_heard_->host == heartbeat.host &&
                         heartbeat.sequence_number < last_heard_->sequence_number && heartbeat.sent > last_heard_->sent;
  if (restarted || (last_heard_ && last_heard_->host != heartbeat.host)) {
    heard_numbers_.clear();
    exchanges_.clear();
  } else if (last_heard_ && heartbeat.sequence_number <= last_heard_->sequence_number) {
    return;
  }
  last_heard_ = heartbeat;
  last_heard_at_ = now;
  heard_numbers_.push_back(heartbeat.sequence_number);
  while (heard_numbers_.back() - heard_numbers_.front() >= kLossWindow) heard_numbers_.pop_front();

  if (heartbeat.heard_host != own_host_) return;
  if (!peer_heard_us_at_ || heartbeat.heard_sent > *peer_heard_us_at_) peer_heard_us_at_ = heartbeat.heard_sent;
  const Time t1 = heartbeat.heard_sent;
  const Time t2 = heartbeat.sent - heartbeat.held;
  const Time t3 = heartbeat.sent;
  const Time t4 = now;
  const Exchange exchange{(t4 - t1) - (t3 - t2), ((t2 - t1) + (t3 - t4)) / 2};
  if (exchange.round_trip < Duration::zero()) return;  // a stamp that cannot be
  const double round_trip_s = to_seconds(exchange.round_trip);
  round_trip_s_ = exchanges_.empty() ? round_trip_s : round_trip_s_ + kSmoothing * (round_trip_s - round_trip_s_);
  exchanges_.push_back(exchange);
  if (exchanges_.size() > kExchanges) exchanges_.pop_front();
}

std::optional<Duration> LinkMonitor::clock_offset() const {
  const auto best = std::min_element(exchanges_.begin(), exchanges_.end(),
                                     [](const auto& a, const auto& b) { return a.round_trip < b.round_trip; });
  if (best == exchanges_.end()) return std::nullopt;
  return best->offset;
}

LinkState LinkMonitor::state(Time now) const {
  LinkState state;
  if (!last_heard_) return state;
  state.peer = last_heard_->host;
  state.heard_age_s = to_seconds(now - last_heard_at_);
  state.up = now - last_heard_at_ <= timeout_;
  state.one_way = state.up && (!peer_heard_us_at_ || now - *peer_heard_us_at_ > timeout_);
  state.round_trip_s = round_trip_s_;
  const auto expected = heard_numbers_.back() - heard_numbers_.front() + 1;
  state.loss = 1.0 - static_cast<double>(heard_numbers_.size()) / static_cast<double>(expected);
  if (const auto offset = clock_offset()) state.clock_offset_s = to_seconds(*offset);
  return state;
}

}  // namespace tandem
