#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/bus/core/endpoint_table.hpp"
#include "services/bus/mailbox.hpp"
#include "services/common/clock.hpp"
#include "services/common/security_files.hpp"
#include "services/common/site_config.hpp"

namespace tandem::bus {

class PeerWatch;

/// Real time, or lockstep replay: then every topic is lossless and nothing is timed.
enum class Pace { RealTime, Lockstep };

/// How the participants of a link find each other.
enum class Discovery {
  Auto,       ///< multicast and peers: works where the Wi-Fi drops multicast, and where nobody was named
  Multicast,  ///< nobody is named
  Peers,      ///< those that are named, by unicast alone
  Server,     ///< named participants keep the list for all: few announcements where robots are many
};

/// The word of site.toml as a value; it must be one of those.
[[nodiscard]] Discovery discovery_of(std::string_view word);

/// How to join one DDS domain.
struct DomainOptions {
  enum class Kind { Host, Link };
  Kind kind = Kind::Host;
  int domain = 0;
  std::string participant;            ///< name shown to others: "planner@laptop1"
  std::string address = "127.0.0.1";  ///< of the only interface used
  Discovery discovery = Discovery::Multicast;
  std::vector<std::string> peers;       ///< addresses to announce to, for Auto and Peers
  std::vector<std::string> servers;     ///< addresses of the discovery servers, for Server; whoever has one is one
  std::vector<std::string> partitions;  ///< teams on the link; empty on a host domain
  /// DDS Security with these files, not with Server; none: without. Fast DDS says little of what is wrong with them:
  /// services/security/check.hpp does.
  std::optional<SecurityFiles> security;
  double bulk_rate_bps = 1.6e6;  ///< bits per second that States may take of the link
  Pace pace = Pace::RealTime;
};

/// The host domain of `site` for the service `service`.
[[nodiscard]] DomainOptions host_domain(const SiteConfig& site, const std::string& service, Pace pace = Pace::RealTime);

/// Somebody in the domain with whom nothing is exchanged, for reasons of security.
struct RefusedPeer {
  std::string name;    ///< as it calls itself, which proves nothing
  std::string reason;  ///< what is wrong with it or with us, as far as can be known
};

/// Sends raw samples.
class RawWriter {
 public:
  virtual ~RawWriter() = default;
  /// Publishes `payload` (CDR with encapsulation header). `source_time` default: now.
  virtual bool write(const std::vector<std::uint8_t>& payload, const KeyHash& key,
                     std::optional<Time> source_time = {}) = 0;
  /// Says that the instance has ended.
  virtual bool dispose(const KeyHash& key) = 0;
  /// Says that nobody writes the instance any more: its readers keep it, marked.
  virtual bool withdraw(const KeyHash& key) = 0;
  /// Writes the last sample of the instance again, with its old source time. False if there is none.
  virtual bool renew(const KeyHash& key) = 0;
  [[nodiscard]] virtual int matched_readers() const = 0;
  /// Waits until every matched reliable reader has acknowledged everything. False on time-out.
  virtual bool wait_for_acknowledgments(Duration timeout) = 0;
  [[nodiscard]] virtual WriterId id() const = 0;
};

/// Sends messages of one topic.
template <class Message, class PubSubType>
class Writer {
 public:
  explicit Writer(std::unique_ptr<RawWriter> raw) : raw_(std::move(raw)) {}
  bool write(const Message& message) { return raw_->write(encode<PubSubType>(message), key_of<PubSubType>(message)); }
  bool dispose(const Message& message) { return raw_->dispose(key_of<PubSubType>(message)); }
  [[nodiscard]] RawWriter& raw() { return *raw_; }

 private:
  std::unique_ptr<RawWriter> raw_;
};

/// Owns a DDS reader; its mailbox stays filled as long as it lives.
class Subscription {
 public:
  virtual ~Subscription() = default;
  [[nodiscard]] virtual int matched_writers() const = 0;
  /// Samples that were dropped because they were not a message of the topic.
  [[nodiscard]] virtual std::uint64_t malformed() const = 0;
};

/// The newest of a topic: for control, where only the newest counts.
template <class Message, class PubSubType>
class Latest {
 public:
  Latest(std::shared_ptr<LatestBox> box, std::unique_ptr<Subscription> subscription)
      : box_(std::move(box)), subscription_(std::move(subscription)) {}
  /// The newest sample, as often as asked; none before the first, or when it cannot be decoded.
  [[nodiscard]] std::optional<Received<Message>> newest() const { return decoded(box_->newest()); }
  /// The newest sample, once.
  [[nodiscard]] std::optional<Received<Message>> take_new() { return decoded(box_->take_new()); }
  /// The newest sample of each instance of a keyed topic that was not disposed of.
  [[nodiscard]] std::vector<Received<Message>> each() const {
    std::vector<Received<Message>> all;
    for (auto& raw : box_->each()) {
      if (auto one = decoded(std::move(raw))) all.push_back(std::move(*one));
    }
    return all;
  }
  [[nodiscard]] int matched_writers() const { return subscription_->matched_writers(); }

 private:
  static std::optional<Received<Message>> decoded(std::optional<RawSample> raw) {
    if (!raw) return std::nullopt;
    auto message = decode<PubSubType>(raw->payload);
    if (!message) return std::nullopt;
    return Received<Message>{std::move(*message), raw->received, raw->source_time, raw->writer, raw->writer_alive};
  }
  std::shared_ptr<LatestBox> box_;
  std::unique_ptr<Subscription> subscription_;
};

/// Every sample of a topic in order of arrival: for localization, tracker, recorder, and for Events.
template <class Message, class PubSubType>
class InOrder {
 public:
  InOrder(std::shared_ptr<InOrderBox> box, std::unique_ptr<Subscription> subscription)
      : box_(std::move(box)), subscription_(std::move(subscription)) {}
  /// All that came since the last call; malformed samples were left out and counted.
  [[nodiscard]] std::vector<Received<Message>> take() {
    std::vector<Received<Message>> all;
    for (const auto& raw : box_->take()) {
      if (raw.kind != RawSample::Kind::Data) continue;
      if (auto message = decode<PubSubType>(raw.payload)) {
        all.push_back({std::move(*message), raw.received, raw.source_time, raw.writer, raw.writer_alive});
      }
    }
    return all;
  }
  [[nodiscard]] std::uint64_t dropped() const { return box_->dropped(); }
  [[nodiscard]] std::uint64_t undecodable() const { return subscription_->malformed(); }
  [[nodiscard]] int matched_writers() const { return subscription_->matched_writers(); }

 private:
  std::shared_ptr<InOrderBox> box_;
  std::unique_ptr<Subscription> subscription_;
};

/// One participant in one DDS domain; readers and writers end before it. Throws std::runtime_error when the domain
/// cannot be joined.
class Bus {
 public:
  explicit Bus(const DomainOptions& options);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  template <class PubSubType>
  [[nodiscard]] Writer<typename PubSubType::type, PubSubType> writer(const Topic<PubSubType>& topic) {
    return Writer<typename PubSubType::type, PubSubType>{raw_writer(info_of(topic))};
  }
  template <class PubSubType>
  [[nodiscard]] Latest<typename PubSubType::type, PubSubType> latest(const Topic<PubSubType>& topic) {
    auto box = std::make_shared<LatestBox>();
    return {box, subscribe(info_of(topic), box)};
  }
  template <class PubSubType>
  [[nodiscard]] InOrder<typename PubSubType::type, PubSubType> in_order(const Topic<PubSubType>& topic,
                                                                        std::size_t limit = 10'000) {
    auto box = std::make_shared<InOrderBox>(limit);
    return {box, subscribe(info_of(topic), box)};
  }
  /// For those who copy payloads: relay, recorder, replayer.
  [[nodiscard]] std::unique_ptr<RawWriter> raw_writer(const TopicInfo& topic);
  [[nodiscard]] std::unique_ptr<Subscription> subscribe(const TopicInfo& topic, std::shared_ptr<Mailbox> mailbox);

  /// Sleeps until any mailbox of this bus gets a sample it did not have at the last return, or `timeout` has passed.
  bool wait(Duration timeout);
  /// Monotonic mission time; what `received` is stamped with.
  [[nodiscard]] const Clock& clock() const;
  [[nodiscard]] Pace pace() const;
  /// Those who are refused now, or refuse us; no more than a handful.
  [[nodiscard]] std::vector<RefusedPeer> refused_peers() const;
  /// What others in this domain do wrong, as far as our own readers and writers are concerned; or among all.
  [[nodiscard]] std::vector<PeerFault> peer_faults(Concern concern = Concern::Own) const;
  /// Who is in this domain, for those who show it.
  [[nodiscard]] const PeerWatch& peers() const;

 private:
  class Participant;
  std::unique_ptr<Participant> participant_;
};

/// Waits until `condition` holds, woken by arrivals on `bus`. False after `timeout`.
bool wait_until(Bus& bus, Duration timeout, const std::function<bool()>& condition);

}  // namespace tandem::bus
