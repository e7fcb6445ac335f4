#include "services/recorder/player.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "services/recorder/core/disposed_record.hpp"
#include "services/recorder/lockstep_peer.hpp"

namespace tandem::recorder {
namespace {

constexpr Duration kDiscovery = std::chrono::milliseconds{1500};
constexpr Duration kClockPeriod = std::chrono::milliseconds{20};
constexpr Duration kArrival = std::chrono::milliseconds{300};  ///< for what nobody acknowledges
constexpr std::uint64_t kMessagesBetweenReports = 50;          ///< at full speed

Time log_time(std::uint64_t nanoseconds) {
  return from_stamp_ns(static_cast<std::int64_t>(nanoseconds));
}

std::vector<std::uint8_t> bytes_of(mcap::ByteView view) {
  return {view.begin(), view.end()};
}

}  // namespace

Player::Player(mcap::Reader& reader, bus::Bus& bus, ReplayOptions options)
    : reader_(reader), bus_(bus), options_(std::move(options)), clock_(bus.writer(topic::kClock)) {
  make_outputs();
  refuse_beside_a_base();
  for (auto& [topic, output] : outputs_) {
    if (!output.writer) output.writer = writer_of(output);
  }
  // A replay at free rate starts a time of its own, whatever was replayed before; lockstep feeds fresh services.
  if (!options_.lockstep) epoch_ = static_cast<std::uint32_t>(to_stamp_ns(bus_.clock().now()) / 1'000'000'000);
}

void Player::refuse_beside_a_base() {
  const auto base = bus_.latest(topic::kBaseStatus);
  if (bus::wait_until(bus_, kDiscovery, [&base] { return base.matched_writers() > 0; })) {
    throw std::runtime_error(
        "a base is connected to this DDS domain (something writes base_status): a recording is not replayed beside a "
        "robot. Stop it, or choose another domain with --domain");
  }
}

void Player::make_outputs() {
  for (const auto& [id, channel] : reader_.channels()) {
    const auto disposed = disposed_topic(channel.topic);
    const std::string topic = disposed.value_or(channel.topic);
    if (!is_replayed(topic, options_)) continue;
    const auto info = std::find_if(all_topics().begin(), all_topics().end(),
                                   [&topic](const TopicInfo& candidate) { return candidate.name == topic; });
    if (info == all_topics().end()) continue;  // of another program
    channel_topics_[id] = topic;
    if (disposed) disposed_channels_.insert(id);
    if (outputs_.contains(topic)) continue;
    const auto renamed = options_.rename.find(topic);
    const std::string name = renamed == options_.rename.end() ? topic : renamed->second;
    Output& output = outputs_.emplace(topic, Output{name, &*info, bus::PayloadType{*info}, nullptr}).first->second;
    // While we look for a base, the others' readers find our writers; only that of base_status must wait.
    if (name != topic::kBaseStatus.name) output.writer = writer_of(output);
  }
  if (outputs_.empty()) throw std::runtime_error("the recording holds none of the topics to replay");
}

std::unique_ptr<bus::RawWriter> Player::writer_of(const Output& output) {
  TopicInfo info = *output.info;
  info.name = output.name;
  return bus_.raw_writer(info);
}

Player::Output* Player::output_of(std::uint16_t channel_id) {
  const auto topic = channel_topics_.find(channel_id);
  return topic == channel_topics_.end() ? nullptr : &outputs_.at(topic->second);
}

void Player::send(const mcap::Message& message, Output& output) {
  if (disposed_channels_.contains(message.channel_id)) {
    if (const auto key = disposed_key(message.data)) output.writer->dispose(*key);
  } else if (const auto key = output.type.key_of(message.data)) {
    output.writer->write(bytes_of(message.data), *key, log_time(message.publish_time));
  }
  ++sent_;
}

void Player::send_latched_before(std::size_t first) {
  std::map<std::pair<Output*, bus::KeyHash>, std::size_t> newest;
  for (std::size_t i = 0; i < first; ++i) {
    Output* output = output_of(reader_.channel_at(i));
    if (output == nullptr || output->info->delivery != Delivery::State) continue;
    const auto message = reader_.message_at(i);
    if (!message) continue;
    if (disposed_channels_.contains(message->channel_id)) {
      if (const auto key = disposed_key(message->data)) newest.erase({output, *key});
    } else if (const auto key = output->type.key_of(message->data)) {
      newest[{output, *key}] = i;
    }
  }
  for (const auto& [instance, index] : newest) {
    if (const auto message = reader_.message_at(index)) send(*message, *instance.first);
  }
}

void Player::send_clock(Time time, double rate) {
  msg::Clock clock;
  clock.stamp_ns(to_stamp_ns(time));
  clock.rate(rate);
  clock.epoch(epoch_);
  clock_.write(clock);
}

bool Player::wait_until_due(Time logged, ReplayPace& pace, const Pass& pass) {
  for (Time now = bus_.clock().now(); pace.is_stopped() || now < pace.due(logged); now = bus_.clock().now()) {
    switch (pass.steer(pass.share)) {
      case ReplayWish::End:
        return false;
      case ReplayWish::Step:
        pace.step_to(logged);
        send_clock(logged, 0.0);
        return true;
      case ReplayWish::Pause:
        pace.stop(now);
        break;
      case ReplayWish::Play:
        pace.go_on(now);
        break;
    }
    send_clock(pace.mission_time(now), pace.is_stopped() ? 0.0 : options_.rate);
    const Time slice_end = pace.is_stopped() ? now + kClockPeriod : std::min(pace.due(logged), now + kClockPeriod);
    for (Time t = now; t < slice_end; t = bus_.clock().now()) bus_.wait(slice_end - t);
  }
  return true;
}

void Player::send_scan(const mcap::Message& message, Output& output, const Pass& pass) {
  send_clock(log_time(message.log_time), 0.0);
  for (const auto& [name, other] : outputs_) pass.peer->expect_delivery(*other.writer, name);
  const auto scan = bus::decode<msg::LaserScanPubSubType>(bytes_of(message.data));
  send(message, output);
  if (scan) pass.on_pose(pass.peer->pose_of(scan->stamp_ns(), [&pass] { return !pass.is_to_end(); }));
}

bool Player::play_once(std::size_t first, Time begin, Pass pass) {
  const bool paced = pass.peer == nullptr && options_.rate > 0.0;
  ReplayPace pace{begin, bus_.clock().now(), options_.rate};
  send_latched_before(first);
  for (std::size_t i = first; i < pass.end; ++i) {
    Output* output = output_of(reader_.channel_at(i));
    if (output == nullptr) continue;
    const bool is_scan = output->info->name == topic::kScan.name;
    pass.share = static_cast<double>(i) / static_cast<double>(reader_.message_count());
    const Time logged = log_time(reader_.log_time_at(i));
    if (paced && !wait_until_due(logged, pace, pass)) return false;
    if (!paced && sent_ % kMessagesBetweenReports == 0 && pass.is_to_end()) return false;
    const auto message = reader_.message_at(i);
    if (!message) continue;  // damaged; the reader has noted it
    if (is_scan && pass.peer != nullptr) {
      send_scan(*message, *output, pass);
      continue;
    }
    if (!paced && pass.peer == nullptr) send_clock(logged, 0.0);
    send(*message, *output);
  }
  return true;
}

std::size_t Player::first_at(Time time) const {
  std::size_t first = 0;
  while (first < reader_.message_count() && log_time(reader_.log_time_at(first)) < time) ++first;
  return first;
}

std::uint64_t Player::play(const Steer& steer, const OnPose& on_pose) {
  if (reader_.message_count() == 0) throw std::runtime_error("the recording is empty");
  std::optional<LockstepPeer> peer;
  if (options_.lockstep) peer.emplace(bus_);

  const Time start = log_time(reader_.log_time_at(0));
  const Time begin = start + from_seconds(options_.from_s);
  const bool to_the_end = std::isinf(options_.until_s);
  // What was logged at the very end is played, too.
  const std::size_t end =
      to_the_end ? reader_.message_count() : first_at(start + from_seconds(options_.until_s) + Duration{1});
  const Pass pass{steer, on_pose, peer ? &*peer : nullptr, end, 0.0};
  while (play_once(first_at(begin), begin, pass) && options_.loop) ++epoch_;
  for (const auto& [name, output] : outputs_) output.writer->wait_for_acknowledgments(std::chrono::seconds{2});
  // A best-effort sample that is still on its way is lost with its writer: the last ones would be.
  const Time arrived = bus_.clock().now() + kArrival;
  for (Time now = bus_.clock().now(); now < arrived; now = bus_.clock().now()) bus_.wait(arrived - now);
  return sent_;
}

}  // namespace tandem::recorder
