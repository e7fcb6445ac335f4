#include "bench/network/sides.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <map>

#include "services/bus/endpoints.hpp"
#include "services/bus/raw_type.hpp"
#include "services/relay/relay_service.hpp"
#include "tests/support/link_authority.hpp"

namespace tandem::bench {
namespace {

namespace dds = eprosima::fastdds::dds;

// Every laboratory is a world of its own: any domain is free in it.
constexpr int kHostDomain = 1;
constexpr int kLinkDomain = 2;

class RelayedSide final : public Side {
 public:
  RelayedSide(test::LabHost& host, const test::RelayOptions& options) : host_(host, options) {}
  std::unique_ptr<bus::RawWriter> writer(const TopicInfo& topic) override { return host_.bus().raw_writer(topic); }
  std::unique_ptr<bus::Subscription> subscribe(const TopicInfo& topic, std::shared_ptr<bus::Mailbox> mailbox) override {
    return host_.bus().subscribe(topic, std::move(mailbox));
  }
  [[nodiscard]] double cpu_s() const override { return host_.relay_cpu_s(); }

 private:
  test::RelayedHost host_;
};

class LinkBusSide final : public Side {
 public:
  LinkBusSide(const test::LabHost& host, const bus::DomainOptions& options)
      : bus_(host.run([&] { return std::make_unique<bus::Bus>(options); })) {}
  std::unique_ptr<bus::RawWriter> writer(const TopicInfo& topic) override { return bus_->raw_writer(topic); }
  std::unique_ptr<bus::Subscription> subscribe(const TopicInfo& topic, std::shared_ptr<bus::Mailbox> mailbox) override {
    return bus_->subscribe(topic, std::move(mailbox));
  }

 private:
  std::unique_ptr<bus::Bus> bus_;
};

class DefaultSide final : public Side {
 public:
  explicit DefaultSide(const test::LabHost& host) {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;  // else it would not use the air
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
    dds::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    participant_ =
        host.run([&] { return dds::DomainParticipantFactory::get_instance()->create_participant(kLinkDomain, qos); });
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~DefaultSide() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  DefaultSide(const DefaultSide&) = delete;
  DefaultSide& operator=(const DefaultSide&) = delete;

  std::unique_ptr<bus::RawWriter> writer(const TopicInfo& info) override {
    dds::DataWriterQos qos;
    set_kind(qos, info.delivery);
    return bus::make_writer(publisher_, topic(info), qos, info, watch_);
  }
  std::unique_ptr<bus::Subscription> subscribe(const TopicInfo& info, std::shared_ptr<bus::Mailbox> mailbox) override {
    dds::DataReaderQos qos;
    set_kind(qos, info.delivery);
    return bus::make_subscription(subscriber_, topic(info), qos, info, std::move(mailbox), {clock_, watch_, [] {}});
  }

 private:
  /// What a program must choose to be served at all; everything else is as it comes.
  template <class Qos>
  static void set_kind(Qos& qos, Delivery delivery) {
    const bool stream = delivery == Delivery::SensorStream;
    const bool latched = delivery == Delivery::State || delivery == Delivery::Bulk;
    qos.reliability().kind = stream ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    if (delivery == Delivery::Event) qos.history().depth = 10;
    qos.data_sharing().off();
  }
  dds::Topic* topic(const TopicInfo& info) {
    auto& topic = topics_[std::string{info.name}];
    if (topic == nullptr) {
      const dds::TypeSupport type{new bus::RawType{info.make_type}};
      type.register_type(participant_);
      topic = participant_->create_topic(std::string{info.name}, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    }
    return topic;
  }

  SteadyClock clock_;
  bus::PeerWatch watch_{"defaults", false, clock_};  // the readers and writers tell it; it listens to nobody
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
  std::map<std::string, dds::Topic*> topics_;
};

}  // namespace

std::unique_ptr<Side> make_side(const std::string& whose, test::LabHost& host, const std::string& peer_address) {
  if (whose == "default") return std::make_unique<DefaultSide>(host);
  test::RelayOptions options;
  options.role = host.name() == "robot" ? "robot" : "laptop";
  options.host_domain = kHostDomain;
  options.link_domain = kLinkDomain;
  options.link.peers = {peer_address};
  if (whose == "secured") {
    static const test::LinkAuthority authority;
    options.security_folder =
        authority.files_of(host.name(), host.name() == "robot" ? HostRole::Robot : HostRole::Laptop);
  }
  return std::make_unique<RelayedSide>(host, options);
}

std::unique_ptr<Side> make_link_side(const std::string& whose, test::LabHost& host, const std::string& peer_address) {
  if (whose == "default") return std::make_unique<DefaultSide>(host);
  SiteConfig site;
  site.host = host.name();
  site.link_domain = kLinkDomain;
  site.peers = {peer_address};
  return std::make_unique<LinkBusSide>(host, link_domain(site, RelayConfig{}, host.address()));
}

void Arrivals::put(bus::RawSample sample) {
  const std::lock_guard lock{mutex_};
  samples_.push_back(std::move(sample));
}

std::vector<bus::RawSample> Arrivals::take() {
  const std::lock_guard lock{mutex_};
  return std::exchange(samples_, {});
}

}  // namespace tandem::bench
