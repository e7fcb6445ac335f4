#include "services/bus/bus.hpp"

#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/utils/IPFinder.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <map>
#include <mutex>
#include <stdexcept>

#include "services/bus/endpoints.hpp"
#include "services/bus/guarded_transport.hpp"
#include "services/bus/outside_settings.hpp"
#include "services/bus/participant_qos.hpp"
#include "services/bus/peer_watch.hpp"
#include "services/bus/qos.hpp"
#include "services/bus/raw_type.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

bool is_address_of_this_machine(const std::string& address) {
  std::vector<rtps::IPFinder::info_IP> addresses;
  rtps::IPFinder::getIPs(&addresses, true);
  return std::any_of(addresses.begin(), addresses.end(), [&](const auto& own) { return own.name == address; });
}

/// Two participants of one process talk over sockets like any others, so that a test sees what the wire does.
void always_use_the_transport() {
  static std::once_flag once;
  std::call_once(once, [] {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  });
}

}  // namespace

DomainOptions host_domain(const SiteConfig& site, const std::string& service, Pace pace) {
  DomainOptions options;
  options.kind = DomainOptions::Kind::Host;
  options.domain = static_cast<int>(site.host_domain);
  options.participant = service + "@" + site.host;
  options.pace = pace;
  return options;
}

class Bus::Participant {
 public:
  explicit Participant(const DomainOptions& options)
      : options_(options), watch_(options.participant, options.security.has_value(), clock_) {
    // Fast DDS itself would only log, and never send.
    if (!is_address_of_this_machine(options.address)) refuse();
    refuse_what_breaks_security(options);
    always_use_the_transport();
    for (const auto& setting : outside_settings(options)) {
      spdlog::warn("Fast DDS is set from outside: {} participant={}", setting, options.participant);
    }
    auto* factory = dds::DomainParticipantFactory::get_instance();
    auto qos = participant_qos(options);
    if (has_outside_profile(*factory, options, qos)) {
      spdlog::warn("QoS from a Fast DDS profile: profile={} participant={}", kOutsideProfile, options.participant);
    }
    // Nobody but this host's own processes reaches a host domain.
    if (options.kind == DomainOptions::Kind::Link) {
      guard_transports(qos, options.security.has_value(),
                       [this](const std::string& from, RtpsFault fault) { dropped(from, fault); });
    }
    participant_ = create(*factory, qos);
    if (participant_ != nullptr) {
      publisher_ = participant_->create_publisher(publisher_qos(options));
      subscriber_ = participant_->create_subscriber(subscriber_qos(options));
    }
    if (publisher_ == nullptr || subscriber_ == nullptr) refuse();
  }

  ~Participant() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  dds::Topic* topic(const TopicInfo& info) {
    const std::lock_guard lock{topics_mutex_};
    const std::string name{info.name};
    if (const auto known = topics_.find(name); known != topics_.end()) return known->second;
    const dds::TypeSupport type{new RawType{info.make_type}};
    type.register_type(participant_);
    dds::Topic* created = participant_->create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    if (created == nullptr) throw std::runtime_error("topic " + name + " cannot be created");
    return topics_[name] = created;
  }

  void notify() {
    {
      const std::lock_guard lock{arrivals_mutex_};
      ++arrivals_;
    }
    arrived_.notify_all();
  }

  bool wait(Duration timeout) {
    std::unique_lock lock{arrivals_mutex_};
    const bool arrived = arrived_.wait_for(lock, timeout, [this] { return arrivals_ != seen_; });
    seen_ = arrivals_;
    return arrived;
  }

  /// Participants with given ids take them in turn. Fast DDS makes the GUID of process and id: one that came back with
  /// another address but the old id would be taken for the old one, until that is forgotten.
  [[nodiscard]] dds::DomainParticipant* create(dds::DomainParticipantFactory& factory, dds::DomainParticipantQos qos) {
    static std::atomic<int> turn = 0;
    const auto domain = static_cast<dds::DomainId_t>(options_.domain);
    const auto join = [&] { return factory.create_participant(domain, qos, &watch_, dds::StatusMask::none()); };
    if (qos.wire_protocol().participant_id < 0) return join();
    for (int i = 0; i < kLinkIds; ++i) {
      qos.wire_protocol().participant_id = kFirstLinkId + turn++ % kLinkIds;
      if (auto* made = join()) return made;
    }
    qos.wire_protocol().participant_id = -1;  // all taken: those who name us find us by our own announcements
    return join();
  }

  /// The first is named as a wrong peer; of a flood the log says how it grows.
  void dropped(const std::string& from, RtpsFault fault) {
    const std::uint64_t count = watch_.dropped(from, fault);
    std::uint64_t power = 10;
    while (power < count) power *= 10;
    if (count == power) spdlog::warn("datagrams dropped: from={} count={} fault={}", from, count, text_of(fault));
  }

  [[noreturn]] void refuse() const {
    throw std::runtime_error("DDS domain " + std::to_string(options_.domain) + " cannot be joined at " +
                             options_.address + ": is that an address of this machine? See site.toml" +
                             (options_.security ? ". Or Fast DDS takes the files of secure_link for unusable: tandem "
                                                  "secure check"
                                                : ""));
  }

  DomainOptions options_;
  SteadyClock clock_;
  PeerWatch watch_;  // outlives the participant
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;

 private:
  std::mutex topics_mutex_;
  std::map<std::string, dds::Topic*> topics_;
  std::mutex arrivals_mutex_;
  std::condition_variable arrived_;
  std::uint64_t arrivals_ = 0;
  std::uint64_t seen_ = 0;
};

Bus::Bus(const DomainOptions& options) : participant_(std::make_unique<Participant>(options)) {}

Bus::~Bus() = default;

std::unique_ptr<RawWriter> Bus::raw_writer(const TopicInfo& topic) {
  const auto& options = participant_->options_;
  auto qos = writer_qos(topic.delivery, options);
  if (has_outside_profile(*participant_->publisher_, std::string{topic.name}, options, qos)) {
    spdlog::warn("QoS from a Fast DDS profile: writer={} participant={}", topic.name, options.participant);
  }
  return make_writer(participant_->publisher_, participant_->topic(topic), qos, topic, participant_->watch_);
}

std::unique_ptr<Subscription> Bus::subscribe(const TopicInfo& topic, std::shared_ptr<Mailbox> mailbox) {
  const auto& options = participant_->options_;
  auto qos = reader_qos(topic.delivery, options);
  if (has_outside_profile(*participant_->subscriber_, std::string{topic.name}, options, qos)) {
    spdlog::warn("QoS from a Fast DDS profile: reader={} participant={}", topic.name, options.participant);
  }
  return make_subscription(participant_->subscriber_, participant_->topic(topic), qos, topic, std::move(mailbox),
                           {participant_->clock_, participant_->watch_, [this] { participant_->notify(); }});
}

bool Bus::wait(Duration timeout) {
  return participant_->wait(timeout);
}

const Clock& Bus::clock() const {
  return participant_->clock_;
}

Pace Bus::pace() const {
  return participant_->options_.pace;
}

std::vector<RefusedPeer> Bus::refused_peers() const {
  return participant_->watch_.refused();
}

std::vector<PeerFault> Bus::peer_faults(Concern concern) const {
  return participant_->watch_.faults(concern);
}

const PeerWatch& Bus::peers() const {
  return participant_->watch_;
}

bool wait_until(Bus& bus, Duration timeout, const std::function<bool()>& condition) {
  const Time deadline = bus.clock().now() + timeout;
  while (!condition()) {
    const Duration left = deadline - bus.clock().now();
    if (left <= Duration::zero()) return false;
    bus.wait(std::min(left, Duration{std::chrono::milliseconds{50}}));
  }
  return true;
}

}  // namespace tandem::bus
