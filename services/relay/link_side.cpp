#include "services/relay/link_side.hpp"

#include "services/relay/relay_messages.hpp"

namespace tandem {
namespace {

/// How long after the other host's writer was found a State that still lives has come again.
constexpr Duration kResynchronised = std::chrono::seconds{10};

/// Passes on that an instance ended, or lost or found again its writer: a State never looks more alive over there.
void pass_on(bus::RawSample::Kind kind, const bus::KeyHash& key, bus::RawWriter& writer) {
  switch (kind) {
    case bus::RawSample::Kind::Disposed:
      writer.dispose(key);
      break;
    case bus::RawSample::Kind::NoWriter:
      writer.withdraw(key);
      break;
    case bus::RawSample::Kind::WriterBack:
      writer.renew(key);
      break;
    case bus::RawSample::Kind::Data:
      break;
  }
}

}  // namespace

/// A topic from the host's services to the link.
class LinkSide::OutwardRoute {
 public:
  OutwardRoute(const TopicInfo& topic, HostRole role, bus::Bus& host, bus::Bus& link, std::size_t scan_beams)
      : topic_(topic.name),
        own_readers_(carries(rule_of(topic), role, Crossing::LinkToHost) ? 1 : 0),
        thins_scans_(topic.name == topic::kScan.name),
        scan_beams_(scan_beams),
        gate_(rule_of(topic)),
        box_(std::make_shared<bus::InOrderBox>(1000)),
        writer_(link.raw_writer(topic)),
        subscription_(host.subscribe(topic, box_)) {}

  [[nodiscard]] bus::WriterId writer_id() const { return writer_->id(); }
  [[nodiscard]] bool finds_other() const { return writer_->matched_readers() > own_readers_; }
  [[nodiscard]] const std::string& topic() const { return topic_; }

  void forward(Time now, const std::set<bus::WriterId>& own) {
    for (const auto& sample : box_->take()) {
      if (own.contains(sample.writer)) continue;
      if (sample.kind != bus::RawSample::Kind::Data) {
        pass_on(sample.kind, sample.key, *writer_);
      } else if (gate_.passes(sample.key, now, to_seconds(now - sample.source_time))) {
        writer_->write(thins_scans_ ? thinned_payload(sample.payload) : sample.payload, sample.key, sample.source_time);
      }
    }
  }

 private:
  [[nodiscard]] std::vector<std::uint8_t> thinned_payload(const std::vector<std::uint8_t>& payload) const {
    const auto scan = bus::decode<msg::LaserScanPubSubType>(payload);
    return scan ? bus::encode<msg::LaserScanPubSubType>(thinned(*scan, scan_beams_)) : payload;
  }

  std::string topic_;
  int own_readers_;  // a topic of both directions is matched by ourselves, too
  bool thins_scans_;
  std::size_t scan_beams_;
  ForwardingGate gate_;
  std::shared_ptr<bus::InOrderBox> box_;  // shared with the subscription, which may still be filling it at the end
  std::unique_ptr<bus::RawWriter> writer_;
  std::unique_ptr<bus::Subscription> subscription_;
};

/// A topic from the link to the host's services.
class LinkSide::InwardRoute {
 public:
  InwardRoute(InwardTopic& to, HostRole role, bus::Bus& link)
      : to_(to),
        own_writers_(carries(rule_of(to.topic), role, Crossing::HostToLink) ? 1 : 0),
        gate_(rule_of(to.topic)),
        box_(std::make_shared<bus::InOrderBox>(1000)),
        subscription_(link.subscribe(to.topic, box_)) {
    to_.ledger.begin_round();
  }
  /// Nobody vouches any more for what it brought: marked, until it comes again over the next link.
  ~InwardRoute() {
    for (const auto& key : to_.ledger.living()) to_.writer->withdraw(key);
  }
  InwardRoute(const InwardRoute&) = delete;
  InwardRoute& operator=(const InwardRoute&) = delete;

  [[nodiscard]] bool finds_other() const { return subscription_->matched_writers() > own_writers_; }
  [[nodiscard]] std::string topic() const { return std::string{to_.topic.name}; }

  /// `understood`: the other host's messages mean what ours do; what cannot be understood is left out.
  void forward(Time now, std::optional<Duration> clock_offset, const std::set<bus::WriterId>& own, bool understood) {
    for (const auto& sample : box_->take()) {
      if (!understood || own.contains(sample.writer)) continue;
      if (sample.kind != bus::RawSample::Kind::Data) {
        pass_on(sample.kind, sample.key, *to_.writer);
        if (sample.kind == bus::RawSample::Kind::Disposed) to_.ledger.ended(sample.key);
        continue;
      }
      // The source's clock is the peer's.
      const Time source_time = sample.source_time - clock_offset.value_or(Duration::zero());
      const double age_s = clock_offset ? to_seconds(now - source_time) : 0.0;
      if (!gate_.passes(sample.key, now, age_s)) continue;
      to_.writer->write(sample.payload, sample.key, source_time);
      if (to_.topic.delivery == Delivery::State) to_.ledger.came(sample.key);
    }
    if (!found_ && finds_other()) found_ = now;
    if (!found_ || now - *found_ < kResynchronised) return;
    for (const auto& key : to_.ledger.take_missing()) to_.writer->dispose(key);
  }

 private:
  InwardTopic& to_;
  int own_writers_;  // see own_readers_
  ForwardingGate gate_;
  std::shared_ptr<bus::InOrderBox> box_;
  std::unique_ptr<bus::Subscription> subscription_;
  std::optional<Time> found_;  // when the other host's writer was
};

LinkSide::LinkSide(const bus::DomainOptions& options, HostRole role, const RelayConfig& config, bus::Bus& host,
                   std::vector<InwardTopic>& inward, ClockOffset clock_offset)
    : address_(options.address),
      host_(host),
      link_(options),
      clock_offset_(std::move(clock_offset)),
      heartbeats_out_(link_.writer(topic::kLinkHeartbeat)),
      heartbeats_in_(link_.in_order(topic::kLinkHeartbeat)) {
  for (auto& to : inward) {
    inward_.push_back(std::make_unique<InwardRoute>(to, role, link_));
    own_.insert(to.writer->id());
  }
  const auto scan_beams = static_cast<std::size_t>(config.scan_beams);
  for (const auto& topic : topics_by_urgency()) {
    if (!carries(rule_of(topic), role, Crossing::HostToLink)) continue;
    outward_.push_back(std::make_unique<OutwardRoute>(topic, role, host_, link_, scan_beams));
    own_.insert(outward_.back()->writer_id());
  }
  outward_thread_ = std::thread{[this] { carry_out(); }};
  inward_thread_ = std::thread{[this] { carry_in(); }};
}

LinkSide::~LinkSide() {
  ended_ = true;
  outward_thread_.join();
  inward_thread_.join();
}

std::vector<bus::Received<msg::LinkHeartbeat>> LinkSide::heartbeats() {
  auto heard = heartbeats_in_.take();
  std::erase_if(heard, [&](const auto& heartbeat) { return heartbeat.writer == heartbeats_out_.raw().id(); });
  return heard;
}

std::vector<std::string> LinkSide::unmatched() const {
  std::vector<std::string> topics;
  for (const auto& route : outward_) {
    if (!route->finds_other()) topics.push_back(route->topic());
  }
  for (const auto& route : inward_) {
    if (!route->finds_other()) topics.push_back(route->topic());
  }
  return topics;
}

bool LinkSide::finds_other() const {
  return heartbeats_in_.matched_writers() > 1 ||  // one is ours
         unmatched().size() < outward_.size() + inward_.size();
}

void LinkSide::carry_out() {
  while (!ended_) {
    host_.wait(std::chrono::milliseconds{100});
    for (auto& route : outward_) route->forward(host_.clock().now(), own_);
  }
}

void LinkSide::carry_in() {
  while (!ended_) {
    link_.wait(std::chrono::milliseconds{100});
    const auto offset = clock_offset_();
    for (auto& route : inward_) route->forward(link_.clock().now(), offset, own_, understood_);
  }
}

}  // namespace tandem
