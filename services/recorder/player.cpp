#include "services/recorder/player.hpp"

#include <algorithm>
#include <stdexcept>

#include "services/recorder/core/disposed_record.hpp"
#include "services/recorder/lockstep_peer.hpp"

namespace tandem::recorder {
namespace {

constexpr Duration kDiscovery = std::chrono::milliseconds{1500};
constexpr Duration kClockPeriod = std::chrono::milliseconds{20};
constexpr std::uint64_t kMessagesBetweenReports = 50;  ///< at full speed

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
    if (!output.writer) output.writer = bus_.raw_writer(*output.info);
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
    // While we look for a base, the others' readers find our writers; only that of base_status must wait.
    const bool waits = topic == topic::kBaseStatus.name;
    outputs_.emplace(topic, Output{&*info, bus::PayloadType{*info}, waits ? nullptr : bus_.raw_writer(*info)});
  }
  if (outputs_.empty()) throw std::runtime_error("the recording holds none of the topics to replay");
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
  std::map<std::pair<std::uint16_t, bus::KeyHash>, std::size_t> newest;
  for (std::size_t i = 0; i < first; ++i) {
    Output* output = output_of(reader_.channel_at(i));
    if (output == nullptr || output->info->delivery != Delivery::State) continue;
    const auto message = reader_.message_at(i);
    if (!message || disposed_channels_.contains(message->channel_id)) continue;
    if (const auto key = output->type.key_of(message->data)) newest[{message->channel_id, *key}] = i;
  }
  for (const auto& [instance, index] : newest) {
    if (const auto message = reader_.message_at(index)) send(*message, *output_of(instance.first));
  }
}

void Player::send_clock(Time time, double rate) {
  msg::Clock clock;
  clock.stamp_ns(to_stamp_ns(time));
  clock.rate(rate);
  clock.epoch(epoch_);
  clock_.write(clock);
}

bool Player::wait_until(Time due, const ReplayPace& pace, const std::function<bool()>& keep_going) {
  for (Time now = bus_.clock().now(); now < due; now = bus_.clock().now()) {
    send_clock(pace.mission_time(now), options_.rate);
    if (!keep_going()) return false;
    const Time slice_end = std::min(due, now + kClockPeriod);
    for (Time t = now; t < slice_end; t = bus_.clock().now()) bus_.wait(slice_end - t);
  }
  return true;
}

void Player::send_scan(const mcap::Message& message, Output& output, const Pass& pass) {
  send_clock(log_time(message.log_time), 0.0);
  for (const auto& [name, other] : outputs_) pass.peer->expect_delivery(*other.writer, name);
  const auto scan = bus::decode<msg::LaserScanPubSubType>(bytes_of(message.data));
  send(message, output);
  if (scan) pass.on_pose(pass.peer->pose_of(scan->stamp_ns(), [&pass] { return pass.keep_going(pass.share); }));
}

bool Player::play_once(std::size_t first, Time begin, Pass pass) {
  const bool paced = pass.peer == nullptr && options_.rate > 0.0;
  const ReplayPace pace{begin, bus_.clock().now(), options_.rate};
  send_latched_before(first);
  for (std::size_t i = first; i < reader_.message_count(); ++i) {
    Output* output = output_of(reader_.channel_at(i));
    if (output == nullptr) continue;
    const bool is_scan = output->info->name == topic::kScan.name;
    pass.share = static_cast<double>(i) / static_cast<double>(reader_.message_count());
    const Time logged = log_time(reader_.log_time_at(i));
    const auto going = [&pass] { return pass.keep_going(pass.share); };
    if (paced && !wait_until(pace.due(logged), pace, going)) return false;
    if (!paced && sent_ % kMessagesBetweenReports == 0 && !going()) return false;
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

std::uint64_t Player::play(const KeepGoing& keep_going, const OnPose& on_pose) {
  if (reader_.message_count() == 0) throw std::runtime_error("the recording is empty");
  std::optional<LockstepPeer> peer;
  if (options_.lockstep) peer.emplace(bus_);

  const Time begin = log_time(reader_.log_time_at(0)) + from_seconds(options_.from_s);
  std::size_t first = 0;
  while (first < reader_.message_count() && log_time(reader_.log_time_at(first)) < begin) ++first;
  const Pass pass{keep_going, on_pose, peer ? &*peer : nullptr, 0.0};
  while (play_once(first, begin, pass) && options_.loop) ++epoch_;
  for (const auto& [name, output] : outputs_) output.writer->wait_for_acknowledgments(std::chrono::seconds{2});
  return sent_;
}

}  // namespace tandem::recorder
