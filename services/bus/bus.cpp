#include "services/bus/bus.hpp"

#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/utils/IPFinder.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <map>
#include <mutex>
#include <stdexcept>

#include "services/bus/qos.hpp"
#include "services/bus/raw_type.hpp"

namespace tandem::bus {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

WriterId to_writer_id(const rtps::GUID_t& guid) {
  WriterId id{};
  for (std::size_t i = 0; i < 12; ++i) id[i] = guid.guidPrefix.value[i];
  for (std::size_t i = 0; i < 4; ++i) id[12 + i] = guid.entityId.value[i];
  return id;
}

rtps::InstanceHandle_t to_handle(const KeyHash& key) {
  rtps::InstanceHandle_t handle;
  for (std::size_t i = 0; i < key.size(); ++i) handle.value[i] = key[i];
  return handle;
}

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

KeyHash to_key(const rtps::InstanceHandle_t& handle) {
  KeyHash key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = handle.value[i];
  return key;
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
  explicit Participant(const DomainOptions& options) : options_(options) {
    // Fast DDS itself would only log, and never send.
    if (!is_address_of_this_machine(options.address)) refuse();
    always_use_the_transport();
    auto* factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<dds::DomainId_t>(options.domain), participant_qos(options));
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
    const dds::TypeSupport type{new RawType{info.make_type()}};
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

  [[noreturn]] void refuse() const {
    throw std::runtime_error("DDS domain " + std::to_string(options_.domain) + " cannot be joined at " +
                             options_.address + ": is that an address of this machine? See site.toml");
  }

  DomainOptions options_;
  SteadyClock clock_;
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

namespace {

class DdsWriter final : public RawWriter {
 public:
  DdsWriter(dds::Publisher* publisher, dds::DataWriter* writer, bool keyed)
      : publisher_(publisher), writer_(writer), keyed_(keyed) {}
  ~DdsWriter() override { publisher_->delete_datawriter(writer_); }

  bool write(const std::vector<std::uint8_t>& payload, const KeyHash& key, std::optional<Time> source_time) override {
    if (payload.empty()) return false;
    RawPayload raw{payload, key, keyed_};
    last_[key] = payload;
    const rtps::InstanceHandle_t handle = keyed_ ? to_handle(key) : rtps::InstanceHandle_t{};
    if (!source_time) return writer_->write(&raw, handle) == ReturnCode_t::RETCODE_OK;
    const std::int64_t stamp_ns = to_stamp_ns(*source_time);
    eprosima::fastrtps::Time_t stamp;
    stamp.seconds = static_cast<std::int32_t>(stamp_ns / 1'000'000'000);
    stamp.nanosec = static_cast<std::uint32_t>(stamp_ns % 1'000'000'000);
    return writer_->write_w_timestamp(&raw, handle, stamp) == ReturnCode_t::RETCODE_OK;
  }

  bool dispose(const KeyHash& key) override {
    if (!keyed_) return false;
    RawPayload raw{last_.contains(key) ? last_[key] : std::vector<std::uint8_t>{0, 1, 0, 0}, key, true};
    last_.erase(key);
    return writer_->dispose(&raw, to_handle(key)) == ReturnCode_t::RETCODE_OK;
  }

  [[nodiscard]] int matched_readers() const override {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }

  bool wait_for_acknowledgments(Duration timeout) override {
    const auto count = timeout.count();
    return writer_->wait_for_acknowledgments(
               {static_cast<std::int32_t>(count / 1'000'000'000), static_cast<std::uint32_t>(count % 1'000'000'000)}) ==
           ReturnCode_t::RETCODE_OK;
  }

  [[nodiscard]] WriterId id() const override { return to_writer_id(writer_->guid()); }

 private:
  dds::Publisher* publisher_;
  dds::DataWriter* writer_;
  bool keyed_;
  std::map<KeyHash, std::vector<std::uint8_t>> last_;  // Fast DDS wants a sample to dispose of an instance
};

/// Moves samples from the reader into the mailbox, in the reader's thread, and does nothing else there.
class DdsSubscription final : public Subscription, private dds::DataReaderListener {
 public:
  DdsSubscription(dds::Subscriber* subscriber, dds::Topic* topic, const dds::DataReaderQos& qos,
                  std::shared_ptr<Mailbox> mailbox, const Clock& clock, std::function<void()> notify)
      : subscriber_(subscriber), mailbox_(std::move(mailbox)), clock_(clock), notify_(std::move(notify)) {
    dds::StatusMask mask = dds::StatusMask::data_available();
    mask << dds::StatusMask::subscription_matched();
    reader_ = subscriber_->create_datareader(topic, qos, this, mask);
    if (reader_ == nullptr) throw std::runtime_error("topic " + topic->get_name() + " cannot be read");
  }
  ~DdsSubscription() override { subscriber_->delete_datareader(reader_); }

  [[nodiscard]] int matched_writers() const override { return matched_; }

 private:
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    matched_ = status.current_count;
    notify_();
  }

  void on_data_available(dds::DataReader* reader) override {
    RawPayload payload;
    dds::SampleInfo info;
    while (reader->take_next_sample(&payload, &info) == ReturnCode_t::RETCODE_OK) {
      RawSample sample;
      if (info.valid_data) {
        sample.payload = std::move(payload.bytes);
      } else {
        sample.kind = info.instance_state == dds::NOT_ALIVE_DISPOSED_INSTANCE_STATE ? RawSample::Kind::Disposed
                                                                                    : RawSample::Kind::NoWriter;
      }
      sample.key = to_key(info.instance_handle);
      sample.writer = to_writer_id(rtps::iHandle2GUID(info.publication_handle));
      sample.source_time = from_stamp_ns(info.source_timestamp.to_ns());
      sample.received = clock_.now();
      mailbox_->put(std::move(sample));
      payload = {};
    }
    notify_();
  }

  dds::Subscriber* subscriber_;
  std::shared_ptr<Mailbox> mailbox_;  // shared with the reader's owner: a late sample must find it alive
  const Clock& clock_;
  std::function<void()> notify_;
  std::atomic<int> matched_ = 0;
  dds::DataReader* reader_ = nullptr;
};

}  // namespace

Bus::Bus(const DomainOptions& options) : participant_(std::make_unique<Participant>(options)) {}

Bus::~Bus() = default;

std::unique_ptr<RawWriter> Bus::raw_writer(const TopicInfo& topic) {
  dds::Topic* dds_topic = participant_->topic(topic);
  dds::DataWriter* writer =
      participant_->publisher_->create_datawriter(dds_topic, writer_qos(topic.delivery, participant_->options_));
  if (writer == nullptr) throw std::runtime_error("topic " + std::string{topic.name} + " cannot be written");
  return std::make_unique<DdsWriter>(participant_->publisher_, writer, topic.make_type()->m_isGetKeyDefined);
}

std::unique_ptr<Subscription> Bus::subscribe(const TopicInfo& topic, std::shared_ptr<Mailbox> mailbox) {
  return std::make_unique<DdsSubscription>(participant_->subscriber_, participant_->topic(topic),
                                           reader_qos(topic.delivery, participant_->options_), std::move(mailbox),
                                           participant_->clock_, [this] { participant_->notify(); });
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
